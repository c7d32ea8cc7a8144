#include "gpu/device_passport.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "common/base/flush_denormals.h"
#include "common/base/float_bits.h"
#include "gpu/builtins.h"
#include "gpu/compute_records.h"
#include "gpu/context.h"
#include "gpu/passport_inputs.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace twintrace {
namespace {

constexpr const char* kExact = "correctly rounded";
constexpr const char* kKept = "kept";
constexpr std::size_t kBuiltinRecords = 1024;

/// An expression of a, b and c, and what it is by IEEE 754 with every step rounded.
struct Expression {
  const char* name;
  const char* glsl;
  float (*exact)(float a, float b, float c);
};

constexpr Expression kOperations[] = {
    {"addition", "a + b", [](float a, float b, float) { return a + b; }},
    {"subtraction", "a - b", [](float a, float b, float) { return a - b; }},
    {"multiplication", "a * b", [](float a, float b, float) { return a * b; }},
    {"division", "approximateQuotient(a, b)", [](float a, float b, float) { return a / b; }},
    {"square root", "approximateRoot(a)", [](float a, float, float) { return std::sqrt(a); }},
    {"corrected division", "correctedQuotient(a, b)",
     [](float a, float b, float) { return a / b; }},
    {"corrected square root", "correctedRoot(a)",
     [](float a, float, float) { return std::sqrt(a); }},
    {"inversesqrt", "inversesqrt(a)",
     [](float a, float, float) { return static_cast<float>(1.0 / std::sqrt(double{a})); }},
};

/// What compilers like to rewrite, in its written order.
constexpr Expression kRewrites[] = {
    {"a * b + c", "a * b + c", [](float a, float b, float c) { return a * b + c; }},
    {"(a * k) * l", "(a * 3.7) * 0.3", [](float a, float, float) { return (a * 3.7f) * 0.3f; }},
    {"(a + k) + l", "(a + 3.7) + 0.3", [](float a, float, float) { return (a + 3.7f) + 0.3f; }},
    {"(a + b) - a", "(a + b) - a", [](float a, float b, float) { return (a + b) - a; }},
    {"a * b + a * c", "a * b + a * c",
     [](float a, float b, float c) { return a * b + a * c; }},
    {"(a * b + b * c) + c * a", "(a * b + b * c) + c * a",
     [](float a, float b, float c) { return (a * b + b * c) + c * a; }},
    {"a - (2 * b) * c", "a - (2.0 * b) * c",
     [](float a, float b, float c) { return a - (2.0f * b) * c; }},
    {"a / k", "a / 3.0", [](float a, float, float) { return a / 3.0f; }},
    {"1 / (1 / a)", "1.0 / (1.0 / a)", [](float a, float, float) { return 1.0f / (1.0f / a); }},
    {"sqrt(a) * sqrt(a)", "sqrt(a) * sqrt(a)",
     [](float a, float, float) { return std::sqrt(a) * std::sqrt(a); }},
};

/// An expression of a = 2^-127 (a denormal), b = infinity and c = NaN; 0 and 1 are made of them by
/// nothing that a compiler knows.
struct SpecialExpression {
  const char* name;
  const char* bits;
  const char* needed;  ///< for strict maths; null = any value will do
};

constexpr SpecialExpression kSpecials[] = {
    {"denormal inputs", "floatBitsToUint(a * 18446744073709551616.0)", "0x00000000"},
    {"denormal results",
     "floatBitsToUint(uintBitsToFloat(floatBitsToUint(a) + 0x1c400000u) * 1e-20)", "0x00000000"},
    {"NaN < 1", "uint(c < 1.0)", "0x00000000"},
    {"NaN > 1", "uint(c > 1.0)", "0x00000000"},
    {"NaN == NaN", "uint(c == c)", "0x00000000"},
    {"isnan(NaN)", "uint(isnan(c))", nullptr},
    {"isinf(infinity)", "uint(isinf(b))", nullptr},
    {"min(NaN, 1)", "floatBitsToUint(min(c, 1.0))", nullptr},
    {"min(1, NaN)", "floatBitsToUint(min(1.0, c))", nullptr},
    {"max(NaN, 1)", "floatBitsToUint(max(c, 1.0))", nullptr},
    {"max(1, NaN)", "floatBitsToUint(max(1.0, c))", nullptr},
    {"clamp(NaN, 0, 1)", "floatBitsToUint(clamp(c, 0.0, 1.0))", nullptr},
    {"infinity - infinity", "floatBitsToUint(b - b)", nullptr},
    {"1 / infinity", "floatBitsToUint(1.0 / b)", nullptr},
    {"-1 / infinity", "floatBitsToUint(-1.0 / b)", nullptr},
    {"-(1 / infinity) + 0", "floatBitsToUint(-1.0 / b + 0.0)", nullptr},
    {"int(infinity)", "uint(int(b))", nullptr},
    {"int(-infinity)", "uint(int(-b))", nullptr},
    {"int(NaN)", "uint(int(c))", nullptr},
    {"int(3e9)", "uint(int(uintBitsToFloat(floatBitsToUint(b) - 0x304d2fa2u)))", nullptr},
    {"uint(infinity)", "uint(b)", nullptr},
    {"uint(-1.5)", "uint(-uintBitsToFloat(floatBitsToUint(b) - 0x3fc00000u))", nullptr},
    {"uint(NaN)", "uint(c)", nullptr},
    {"float(0xffffffff)", "floatBitsToUint(float(floatBitsToUint(b) | 0xffffffffu))", nullptr},
};

constexpr std::uint32_t kSpecialInputs[] = {0x00400000u, 0x7f800000u, 0x7fc00000u};

float floatOf(std::uint32_t bits) { return std::bit_cast<float>(bits); }

bool isDenormal(float x) { return x != 0.0f && std::fabs(x) < 0x1p-126f; }

/// How often an expression differs from its definition, over the inputs on which flushing denormals
/// makes no difference: those have facts of their own.
class Tally {
 public:
  void add(std::span<const std::uint32_t> record, std::uint32_t found, const Expression& expression) {
    const float a = floatOf(record[0]);
    const float b = floatOf(record[1]);
    const float c = floatOf(record[2]);
    if (isDenormal(a) || isDenormal(b)) return;
    const float kept = expression.exact(a, b, c);
    const float flushed = flushing(expression, a, b, c);
    if (!sameBits(kept, flushed) || isDenormal(kept)) return;
    ++judged_;
    const std::uint32_t distance = ulpDistance(floatOf(found), kept);
    if (distance == 0) return;
    ++wrong_;
    largest_ = std::max(largest_, distance);
  }

  bool exact() const { return wrong_ == 0; }
  std::string misses() const {
    return fmt::format("{} of {} differ, by up to {} ulp", wrong_, judged_, largest_);
  }

 private:
  static float flushing(const Expression& expression, float a, float b, float c) {
    const FlushDenormals flush;
    return expression.exact(a, b, c);
  }

  std::size_t judged_ = 0;
  std::size_t wrong_ = 0;
  std::uint32_t largest_ = 0;
};

Tally tallied(const Expression& expression, std::span<const std::uint32_t> inputs,
              std::span<const std::uint32_t> found) {
  Tally tally;
  for (std::size_t i = 0; i < found.size(); ++i) {
    tally.add(inputs.subspan(kRecordWords * i, kRecordWords), found[i], expression);
  }
  return tally;
}

/// The programs of a passport.
struct Programs {
  RecordProgram strict;
  RecordProgram plain;
  RecordProgram special;
  RecordProgram builtin;
};

Programs passportPrograms() {
  Programs programs;
  programs.strict.head = correctionConstants({}) + "#include \"corrected.glsl\"\n";
  for (const Expression& operation : kOperations) {
    programs.strict.expressions.emplace_back(operation.glsl);
  }
  for (const Expression& rewrite : kRewrites) {
    programs.strict.expressions.emplace_back(rewrite.glsl);
    programs.plain.expressions.emplace_back(rewrite.glsl);
  }
  programs.plain.expressions.emplace_back("fma(a, b, c)");
  programs.plain.precise = false;
  for (const SpecialExpression& special : kSpecials) {
    programs.special.expressions.push_back(std::string(kBitsPrefix) + special.bits);
  }
  for (const Builtin& builtin : builtins()) {
    programs.builtin.expressions.emplace_back(builtin.expression);
  }
  programs.builtin.ownInputs = true;
  programs.builtin.precise = false;
  return programs;
}

std::string hexWord(std::uint32_t word) {
  const bool isNan = (word & 0x7fffffffu) > 0x7f800000u && word != 0xffffffffu;
  return isNan ? "NaN" : fmt::format("{:#010x}", word);
}

std::string hashOf(const void* bytes, std::size_t count) {
  const XXH128_hash_t hash = XXH3_128bits(bytes, count);
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

class Measurement {
 public:
  Measurement(Context& context, const ShaderLibrary& library)
      : context_(context), library_(library), programs_(passportPrograms()) {
    passport_.renderer = context.renderer();
    passport_.version = context.version();
  }

  DevicePassport run() {
    measureStrict();
    measurePlain();
    measureSpecials();
    measureBuiltins();
    return passport_;
  }

 private:
  std::vector<std::uint32_t> results(const RecordProgram& program,
                                     std::span<const std::uint32_t> inputs) {
    return runRecords(context_, recordSource(library_, program), program, inputs);
  }

  void measureStrict() {
    const auto found = results(programs_.strict, inputs_);
    std::size_t block = 0;
    bool exact[std::size(kOperations)];
    for (std::size_t i = 0; i < std::size(kOperations); ++i) {
      const Tally tally = tallied(kOperations[i], inputs_, blockOf(found, block++));
      exact[i] = tally.exact();
      addFact(kOperations[i].name, tally.exact() ? kExact : tally.misses(), false);
    }
    passport_.corrections = {!exact[kDivision], !exact[kRoot]};
    for (const std::size_t i : {kAddition, kSubtraction, kMultiplication}) {
      passport_.facts[i].breaksStrict = !exact[i];
    }
    passport_.facts[kCorrectedDivision].breaksStrict =
        !exact[kDivision] && !exact[kCorrectedDivision];
    passport_.facts[kCorrectedRoot].breaksStrict = !exact[kRoot] && !exact[kCorrectedRoot];
    for (const Expression& rewrite : kRewrites) {
      const std::string value = rewriteValue(rewrite, blockOf(found, block++));
      addFact(std::string("precise ") + rewrite.name, value,
              value != kKept && !needsCorrected(rewrite));
    }
  }

  void measurePlain() {
    const auto found = results(programs_.plain, inputs_);
    std::size_t block = 0;
    for (const Expression& rewrite : kRewrites) {
      addFact(std::string("plain ") + rewrite.name, rewriteValue(rewrite, blockOf(found, block++)),
              false);
    }
    const std::string fused = rewriteValue(kRewrites[0], blockOf(found, block));
    addFact("fma", fused == kKept ? "product, then sum" : fused, false);
  }

  void measureSpecials() {
    const auto found = results(programs_.special, kSpecialInputs);
    for (std::size_t i = 0; i < std::size(kSpecials); ++i) {
      const SpecialExpression& special = kSpecials[i];
      const std::string value = hexWord(found[i]);
      const bool breaks = special.needed != nullptr && value != special.needed;
      if (std::string_view(special.name).starts_with("denormal")) {
        addFact(special.name, breaks ? kKept : "flushed to zero", breaks);
      } else {
        addFact(special.name, value, breaks);
      }
    }
  }

  void measureBuiltins() {
    std::vector<std::uint32_t> inputs;
    for (const Builtin& builtin : builtins()) {
      const auto some = builtinInputs(builtin, kBuiltinRecords, 1);
      inputs.insert(inputs.end(), some.begin(), some.end());
    }
    const auto found = results(programs_.builtin, inputs);
    for (std::size_t i = 0; i < builtins().size(); ++i) {
      addFact(std::string("bits of ") + builtins()[i].name,
              hashOf(&found[i * kBuiltinRecords], kBuiltinRecords * sizeof(std::uint32_t))
                  .substr(0, 8),
              false);
    }
  }

  std::span<const std::uint32_t> blockOf(const std::vector<std::uint32_t>& found,
                                         std::size_t block) const {
    const std::size_t count = inputs_.size() / kRecordWords;
    return std::span(found).subspan(block * count, count);
  }

  /// An expression with a division or root differs on a device that does not round those.
  bool needsCorrected(const Expression& rewrite) const {
    const std::string_view text = rewrite.glsl;
    return (passport_.corrections.division && text.find('/') != text.npos) ||
           (passport_.corrections.root && text.find("sqrt") != text.npos);
  }

  std::string rewriteValue(const Expression& rewrite, std::span<const std::uint32_t> found) const {
    const Tally tally = tallied(rewrite, inputs_, found);
    if (tally.exact()) return kKept;
    constexpr Expression kFused = {"", "",
                                   [](float a, float b, float c) { return std::fma(a, b, c); }};
    if (&rewrite == &kRewrites[0] && tallied(kFused, inputs_, found).exact()) return "fused";
    return tally.misses();
  }

  void addFact(std::string name, std::string value, bool breaksStrict) {
    passport_.facts.push_back({std::move(name), std::move(value), breaksStrict});
  }

  // Places in kOperations, and so of the first facts.
  static constexpr std::size_t kAddition = 0, kSubtraction = 1, kMultiplication = 2, kDivision = 3,
                               kRoot = 4, kCorrectedDivision = 5, kCorrectedRoot = 6;

  Context& context_;
  const ShaderLibrary& library_;
  Programs programs_;
  std::vector<std::uint32_t> inputs_ = arithmeticInputs();
  DevicePassport passport_;
};

}  // namespace

std::string DevicePassport::digest() const {
  std::string all;
  for (const PassportFact& fact : facts) all += fact.name + '\t' + fact.value + '\n';
  return hashOf(all.data(), all.size());
}

bool DevicePassport::isStrict() const {
  return std::ranges::none_of(facts, &PassportFact::breaksStrict);
}

std::string DevicePassport::strictness() const {
  std::vector<std::string> names;
  for (const PassportFact& fact : facts) {
    if (fact.breaksStrict) names.push_back(fact.name + " (" + fact.value + ")");
  }
  if (!names.empty()) return fmt::format("no: {}", fmt::join(names, "; "));
  if (corrections.division) names.emplace_back("division");
  if (corrections.root) names.emplace_back("square root");
  if (!names.empty()) return fmt::format("yes, through corrected {}", fmt::join(names, " and "));
  return "yes";
}

DevicePassport measurePassport(Context& context, const ShaderLibrary& library) {
  return Measurement(context, library).run();
}

std::string passportKey(const Context& context, const ShaderLibrary& library) {
  const Programs programs = passportPrograms();
  std::string all = context.vendor() + '\0' + context.renderer() + '\0' + context.version();
  for (const RecordProgram* program :
       {&programs.strict, &programs.plain, &programs.special, &programs.builtin}) {
    all += '\0' + recordSource(library, *program).text;
  }
  return hashOf(all.data(), all.size());
}

std::vector<std::string> changedFacts(const std::vector<PassportFact>& before,
                                      const std::vector<PassportFact>& after) {
  std::vector<std::string> names;
  const auto missingFrom = [&](const std::vector<PassportFact>& others, const PassportFact& fact) {
    return std::ranges::find_if(others, [&](const PassportFact& other) {
             return other.name == fact.name && other.value == fact.value;
           }) == others.end();
  };
  for (const PassportFact& fact : after) {
    if (missingFrom(before, fact)) names.push_back(fact.name);
  }
  for (const PassportFact& fact : before) {
    const bool named = std::ranges::find(names, fact.name) != names.end();
    if (!named && missingFrom(after, fact)) names.push_back(fact.name);
  }
  return names;
}

}  // namespace twintrace
