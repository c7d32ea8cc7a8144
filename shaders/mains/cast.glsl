// Compute stage: one ray of a case set per invocation.
#include "mains/cast_ray.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 0) writeonly buffer CaseAnswers {
  float caseAnswers[];
};

void main() {
  int index = int(gl_GlobalInvocationID.x);
  if (index >= rayCount) {
    return;
  }
  precise CaseAnswer answer = castRay(index);
  int at = index * kCaseAnswerFloats;
  caseAnswers[at] = answer.t;
  caseAnswers[at + 1] = answer.normal.x;
  caseAnswers[at + 2] = answer.normal.y;
  caseAnswers[at + 3] = answer.normal.z;
  caseAnswers[at + 4] = float(answer.primitive);
}
