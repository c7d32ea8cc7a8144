#include "experiments/explain/statements.h"

#include <bit>

#include "tests/catch.h"

namespace twintrace::test {
namespace {

/// A statement: what it gives a value to, its text, and the value.
struct Statement {
  std::string variable;
  std::string text;
  std::vector<float> value;
};

/// One function that is called once; the last statement is its return.
class Run {
 public:
  explicit Run(const std::vector<Statement>& statements) {
    for (const Statement& s : statements) {
      const bool isReturn = &s == &statements.back();
      TraceSite site{isReturn ? TraceSite::Kind::leave : TraceSite::Kind::local,
                     0,
                     "f:" + std::to_string(program_.sites.size() + 1),
                     {},
                     s.text};
      site.slots = traceSlots({}, {s.value.size() == 1 ? "float" : "vec3", s.variable});
      program_.sites.push_back(site);
      for (const float value : s.value) words_.push_back(std::bit_cast<std::uint32_t>(value));
    }
    call_.function = 0;
    std::size_t at = 0;
    for (const TraceSite& site : program_.sites) {
      const TracedValues values{&site, std::span(words_).subspan(at, site.slots.size())};
      at += site.slots.size();
      if (site.kind == TraceSite::Kind::local) {
        call_.locals.push_back(values);
      } else {
        call_.output = values;
      }
    }
  }

  const TraceProgram& program() const { return program_; }
  const Call& call() const { return call_; }

 private:
  TraceProgram program_;
  std::vector<std::uint32_t> words_;
  Call call_;
};

StatementDifference compared(const Run& a, const Run& b) {
  return firstDifferingStatement(a.program(), a.call(), b.program(), b.call());
}

std::vector<std::string> texts(const std::vector<TracedValues>& statements) {
  std::vector<std::string> found;
  for (const TracedValues& statement : statements) found.push_back(statement.site->text);
  return found;
}

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("firstDifferingStatement names the first variable that differs", "[explain]") {
  const Run a({{"x", "float x = p;", {1}},
               {"y", "float y = x;", {2}},
               {"z", "float z = y;", {3}},
               {"result", "return z;", {3}}});
  const Run b({{"x", "float x = p;", {1}},
               {"y", "float y = x;", {5}},
               {"z", "float z = y;", {6}},
               {"result", "return z;", {6}}});
  const StatementDifference found = compared(a, b);
  CHECK(found.a.site->text == "float y = x;");
  CHECK(found.b.site->place == "f:2");
  const auto words = wordDifferences(found);
  REQUIRE(words.size() == 1);
  CHECK(words[0].path == "y");
  CHECK(std::bit_cast<float>(words[0].b) == 5.0f);
  CHECK(found.suspectsA.empty());
}

TEST_CASE("firstDifferingStatement holds the second value against the second", "[explain]") {
  const Run a({{"x", "float x = p;", {1}}, {"x", "x = x + p;", {2}}, {"result", "return x;", {2}}});
  const Run b({{"x", "float x = p;", {1}}, {"x", "x = x + p;", {3}}, {"result", "return x;", {3}}});
  CHECK(compared(a, b).b.site->place == "f:2");
}

TEST_CASE("firstDifferingStatement compares no name that one side uses otherwise", "[explain]") {
  // The one function computes in two steps what the other does in one.
  const Run a({{"x", "float x = p * q;", {6}}, {"result", "return x + p;", {8}}});
  const Run b(
      {{"x", "float x = p;", {2}}, {"x", "x = x * q;", {6}}, {"result", "return x + q;", {9}}});
  const StatementDifference found = compared(a, b);
  CHECK(found.a.site->text == "return x + p;");
  CHECK(found.b.site->text == "return x + q;");
  CHECK(texts(found.suspectsB) == Texts{"float x = p;", "x = x * q;"});
}

TEST_CASE("firstDifferingStatement suspects what the other side lacks", "[explain]") {
  const Run a({{"shared", "float shared = p;", {1}}, {"result", "return shared * p;", {4}}});
  const Run b({{"unused", "float unused = p;", {7}},
               {"shared", "float shared = p;", {1}},
               {"inner", "float inner = p;", {2}},
               {"factor", "float factor = inner;", {2}},
               {"result", "return shared * factor;", {2}}});
  const StatementDifference found = compared(a, b);
  CHECK(found.b.site->text == "return shared * factor;");
  CHECK(texts(found.suspectsB) == Texts{"float inner = p;", "float factor = inner;"});
}

TEST_CASE("firstDifferingStatement takes what is returned for the result", "[explain]") {
  const Run a({{"result", "return p;", {1, 2, 3}}});
  const Run b({{"made", "vec3 made = p;", {1, 2, 3}},
               {"made", "made.x = 5.0f;", {5, 2, 3}},
               {"made", "made.y = 2.0f;", {5, 2, 3}},
               {"result", "return made;", {5, 2, 3}}});
  const StatementDifference found = compared(a, b);
  CHECK(found.a.site->text == "return p;");
  CHECK(found.b.site->text == "made.x = 5.0f;");
  CHECK(found.suspectsB.empty());
}

TEST_CASE("firstDifferingStatement takes a stale value for no suspect", "[explain]") {
  const Run a({{"result", "return p;", {1}}});
  const Run b(
      {{"x", "float x = p;", {7}}, {"x", "x = p + q;", {8}}, {"result", "return x + q;", {2}}});
  CHECK(texts(compared(a, b).suspectsB) == Texts{"x = p + q;"});
}

TEST_CASE("firstDifferingStatement takes two NaNs and two zeros for equal", "[explain]") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Run a(
      {{"x", "float x = p;", {nan}}, {"y", "float y = p;", {0.0f}}, {"result", "return y;", {1}}});
  const Run b({{"x", "float x = p;", {-nan}},
               {"y", "float y = p;", {-0.0f}},
               {"result", "return y;", {2}}});
  CHECK(compared(a, b).a.site->kind == TraceSite::Kind::leave);
}

}  // namespace twintrace::test
