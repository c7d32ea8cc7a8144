#include "experiments/hulls/hull_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "common/hulls/hull_structure.h"
#include "experiments/hulls/hull_results.h"

namespace twintrace {
namespace {

constexpr double kWidth = 640.0;  // of a plot, in its own units
constexpr double kHeight = 400.0;
constexpr double kLeft = 70.0;
constexpr double kBottom = 50.0;
constexpr double kTop = 14.0;
constexpr double kRight = 28.0;

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else if (c == '&') {
      result += "&amp;";
    } else {
      result += c;
    }
  }
  return result;
}

struct Point {
  double x = 0.0;
  double y = 0.0;
  std::string label;
};

struct Series {
  std::string name;
  std::string colour;
  std::vector<Point> points;
};

/// A logarithmic axis from a power of ten below the least value to one above the greatest.
class LogAxis {
 public:
  LogAxis(double least, double most, double from, double to)
      : low_(std::floor(std::log10(least))),
        high_(std::max(std::ceil(std::log10(most)), low_ + 1.0)),
        from_(from),
        to_(to) {}

  double place(double value) const {
    return from_ + (std::log10(value) - low_) / (high_ - low_) * (to_ - from_);
  }
  std::vector<double> ticks() const {
    std::vector<double> values;
    for (double exponent = low_; exponent <= high_; exponent += 1.0) {
      values.push_back(std::pow(10.0, exponent));
    }
    return values;
  }

 private:
  double low_, high_, from_, to_;
};

LogAxis axisOver(const std::vector<Series>& series, double Point::*part, double from, double to) {
  double least = 1e300;
  double most = 0.0;
  for (const Series& each : series) {
    for (const Point& point : each.points) {
      least = std::min(least, point.*part);
      most = std::max(most, point.*part);
    }
  }
  return {least, most, from, to};
}

std::string axesSvg(const LogAxis& x, const LogAxis& y, const std::string& nameX,
                    const std::string& nameY) {
  std::string svg;
  for (const double value : x.ticks()) {
    const double at = x.place(value);
    svg += fmt::format("<line class='grid' x1='{0:.1f}' x2='{0:.1f}' y1='{1}' y2='{2}'/>"
                       "<text class='tick' x='{0:.1f}' y='{3}' text-anchor='middle'>{4:g}</text>\n",
                       at, kTop, kHeight - kBottom, kHeight - kBottom + 16.0, value);
  }
  for (const double value : y.ticks()) {
    const double at = y.place(value);
    svg += fmt::format("<line class='grid' x1='{1}' x2='{2}' y1='{0:.1f}' y2='{0:.1f}'/>"
                       "<text class='tick' x='{3}' y='{4:.1f}' text-anchor='end'>{5:g}</text>\n",
                       at, kLeft, kWidth - kRight, kLeft - 6.0, at + 4.0, value);
  }
  svg += fmt::format("<text x='{:.0f}' y='{:.0f}' text-anchor='middle'>{}</text>\n",
                     0.5 * (kLeft + kWidth - kRight), kHeight - 10.0, nameX);
  svg += fmt::format("<text transform='translate(16 {:.0f}) rotate(-90)' text-anchor='middle'>{}</text>\n",
                     0.5 * (kTop + kHeight - kBottom), nameY);
  return svg;
}

/// A plot with both axes logarithmic; points of a series are joined if `joined`.
std::string plotSvg(const std::vector<Series>& series, const std::string& nameX,
                    const std::string& nameY, bool joined) {
  const LogAxis x = axisOver(series, &Point::x, kLeft, kWidth - kRight);
  const LogAxis y = axisOver(series, &Point::y, kHeight - kBottom, kTop);
  std::string svg = fmt::format("<svg viewBox='0 0 {} {}' role='img'>\n", kWidth, kHeight);
  svg += axesSvg(x, y, nameX, nameY);
  for (const Series& each : series) {
    std::string path;
    std::string marks;
    for (const Point& point : each.points) {
      const double px = x.place(point.x);
      const double py = y.place(point.y);
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : " L", px, py);
      marks += fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='4' fill='{}'><title>{}</title></circle>\n",
                           px, py, each.colour, escaped(point.label));
    }
    if (joined) svg += fmt::format("<path d='{}' stroke='{}' class='curve'/>\n", path, each.colour);
    svg += marks;
  }
  return svg + "</svg>\n";
}

std::string legend(const std::vector<Series>& series) {
  std::string html = "<p class='legend'>";
  for (const Series& each : series) {
    html += fmt::format("<span><i style='background:{}'></i>{}</span> ", each.colour, escaped(each.name));
  }
  return html + "</p>\n";
}

/// A strategy's own colour, the same in all plots.
std::string colourOf(const std::string& strategy) {
  const auto& all = hullStrategies();
  const auto found = std::ranges::find(all, strategy, &HullStrategy::name);
  if (found == all.end()) return "hsl(0 0% 50%)";
  const auto number = static_cast<std::size_t>(found - all.begin());
  const double turn = static_cast<double>(number) / static_cast<double>(all.size());
  return fmt::format("hsl({:.0f} 70% {}%)", 360.0 * turn, number % 2 == 0 ? 42 : 60);
}

/// Series by strategy, of the runs that `point` has something to show of.
std::vector<Series> seriesOf(std::span<const HullRun> runs,
                             const std::function<bool(const HullRun&, Point&)>& point) {
  std::vector<std::string> names;
  for (const HullRun& run : runs) {
    if (std::ranges::find(names, run.facts.strategy) == names.end()) names.push_back(run.facts.strategy);
  }
  std::vector<Series> result;
  for (const std::string& name : names) {
    Series series{name, colourOf(name), {}};
    for (const HullRun& run : runs) {
      Point shown;
      if (run.facts.strategy == name && point(run, shown)) series.points.push_back(shown);
    }
    std::ranges::sort(series.points, {}, &Point::x);
    if (!series.points.empty()) result.push_back(std::move(series));
  }
  return result;
}

double perRay(std::int64_t count, const HullRun& run) {
  return static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(run.rays, 1));
}

std::string ratesSection(std::span<const HullRun> runs) {
  std::map<std::pair<std::string, RayKind>, std::vector<HullRun>> groups;
  for (const HullRun& run : runs) {
    if (!run.seconds.empty() && run.rays > 0) groups[{run.engine, run.kind}].push_back(run);
  }
  std::string html = "<h2>Rays per second against primitives</h2>\n<div class='plots'>\n";
  for (const auto& [key, group] : groups) {
    const auto series = seriesOf(group, [](const HullRun& run, Point& point) {
      point = {std::max(1.0, double(run.facts.primitives)), 1e9 / measuredNanoseconds(run),
               fmt::format("{}: {:.3f} Mrays/s", runName(run), 1e3 / measuredNanoseconds(run))};
      return true;
    });
    html += fmt::format("<figure><figcaption>{}, {} rays</figcaption>\n", key.first,
                        kRayKindNames[static_cast<std::size_t>(key.second)]);
    html += plotSvg(series, "primitives with bounds", "rays per second", true) + legend(series) + "</figure>\n";
  }
  return html + "</div>\n";
}

std::string testsSection(std::span<const HullRun> runs) {
  const auto series = seriesOf(runs, [](const HullRun& run, Point& point) {
    point = {perRay(run.totals.hullTests, run), perRay(run.totals.primitiveTests, run),
             fmt::format("{}: {:.2f} hull tests, {:.2f} primitive tests a ray", runName(run),
                         perRay(run.totals.hullTests, run), perRay(run.totals.primitiveTests, run))};
    return run.engine != "gpu" && point.x > 0.0 && point.y > 0.0;  // the gpu's are the same
  });
  if (series.empty()) return "";
  return "<h2>Hull tests against primitive tests</h2>\n<div class='plots'><figure>\n" +
         plotSvg(series, "hull tests a ray", "primitive tests a ray", false) + legend(series) +
         "</figure></div>\n";
}

std::string costSection(std::span<const HullCost> costs) {
  if (costs.empty()) return "";
  std::string html =
      "<h2>What a test costs</h2>\n<p>Time of a ray = fixed + hull tests &times; a + primitive tests "
      "&times; b, fitted to all runs of an engine with hulls of one volume and to those without hulls.</p>\n"
      "<div class='wide'><table><tr><th>engine</th><th>volume</th><th>fixed, ns</th><th>hull test, ns</th>"
      "<th>primitive test, ns</th><th>mean error</th><th>runs</th></tr>\n";
  for (const HullCost& cost : costs) {
    html += fmt::format("<tr><td>{}</td><td>{}</td><td>{:.1f}</td><td>{:.2f}</td><td>{:.2f}</td>"
                        "<td>{:.0f} %</td><td>{}</td></tr>\n",
                        cost.engine, cost.volume, cost.fixed, cost.hullTest, cost.primitiveTest,
                        1e2 * cost.error, cost.runs);
  }
  return html + "</table></div>\n";
}

std::string runsSection(std::span<const HullRun> runs) {
  std::string html =
      "<h2>All runs</h2>\n<div class='wide'><table><tr><th>scene/strategy/rays/engine</th><th>primitives</th>"
      "<th>Mrays/s</th><th>hull tests</th><th>primitive tests</th><th>nodes</th><th>build, s</th>"
      "<th>bytes a primitive</th><th>area ratio</th><th>differing</th></tr>\n";
  for (const HullRun& run : runs) {
    if (run.seconds.empty()) {
      html += fmt::format("<tr><td>{}</td><td colspan='9'>{}</td></tr>\n", escaped(runName(run)),
                          escaped(run.missing));
      continue;
    }
    html += fmt::format("<tr><td>{}</td><td>{}</td><td>{:.3f}</td><td>{:.2f}</td><td>{:.2f}</td>"
                        "<td>{:.2f}</td><td>{:.4f}</td><td>{:.1f}</td><td>{:.2f}</td><td>{}</td></tr>\n",
                        escaped(runName(run)), run.facts.primitives, 1e3 / measuredNanoseconds(run),
                        perRay(run.totals.hullTests, run), perRay(run.totals.primitiveTests, run),
                        perRay(run.totals.nodes, run), run.facts.buildSeconds,
                        run.facts.bytesPerPrimitive, run.facts.areaRatio, run.differing);
  }
  return html + "</table></div>\n";
}

constexpr const char* kHead = R"html(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Hull strategies</title>
<style>
:root { color-scheme: light dark; --ink: #1a1a1e; --paper: #fafaf8; --faint: #d8d8d4; }
@media (prefers-color-scheme: dark) { :root { --ink: #e8e8e4; --paper: #17171a; --faint: #3a3a40; } }
body { font: 16px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper);
       max-width: 1400px; margin: 0 auto; padding: 1rem; }
.plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 420px), 1fr)); gap: 1rem; }
figure { margin: 0; max-width: 700px; } figcaption { font-weight: 600; }
svg { width: 100%; height: auto; } svg text { fill: var(--ink); font-size: 14px; }
svg .tick { font-size: 12px; } .grid { stroke: var(--faint); } .curve { fill: none; stroke-width: 2; }
.legend span { display: inline-block; margin-right: 0.8em; font-size: 0.85rem; }
.legend i { display: inline-block; width: 0.8em; height: 0.8em; margin-right: 0.3em; border-radius: 50%; }
.wide { overflow-x: auto; } table { border-collapse: collapse; font-size: 0.85rem; }
th, td { padding: 0.2em 0.7em; text-align: right; border-bottom: 1px solid var(--faint); white-space: nowrap; }
th:first-child, td:first-child { text-align: left; }
</style>
</head>
<body>
<h1>Hull strategies</h1>
<p>Each strategy cast the same rays; repeats went round all strategies in turn, and times are the best of
them. Counters come from a run of their own and are sums over all rays, divided by their number.</p>
)html";

}  // namespace

std::string hullPage(std::span<const HullRun> runs, std::span<const HullCost> costs) {
  return kHead + ratesSection(runs) + testsSection(runs) + costSection(costs) + runsSection(runs) +
         "</body>\n</html>\n";
}

}  // namespace twintrace
