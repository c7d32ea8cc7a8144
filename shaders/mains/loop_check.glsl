// Whether all loops of this invocation ran to their ends. llvmpipe breaks off every loop once an invocation
// has made 65,535 rounds in all, and says nothing: so one more loop is run and its rounds are counted.
#pragma once

uniform int loopRounds;  // 2, where the compiler can't see it

bool loopsHeld() {
  int rounds = 0;
  for (int i = 0; i < loopRounds; ++i) {
    rounds = rounds + 1;
  }
  return rounds == loopRounds;
}
