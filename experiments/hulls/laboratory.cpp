#include "experiments/hulls/laboratory.h"

#include <algorithm>
#include <map>

#include "common/base/error.h"
#include "common/base/wording.h"
#include "common/hulls/hull_structure.h"
#include "common/hulls/tightness.h"
#include "cpu/embree_caster.h"
#include "cpu/hull_caster.h"
#include "experiments/arm.h"
#include "gpu/hull_caster.h"

namespace twintrace {

const std::vector<std::string> kHullEngines = {"cpu", "cpu64", "gpu", "embree", "embree-fast"};

namespace {

/// Embree's own tree and primitives: no strategy of ours.
bool isWitness(const std::string& engine) {
  return engine == "embree" || engine == "embree-fast";
}

RenderOptions engineOptions(RenderOptions options, const std::string& engine,
                            const std::string& strategy) {
  options.hull = strategy;
  options.geometry = Geometry::buffer;  // as with hulls, so that `none` differs by them alone
  options.backend = engine == "gpu" ? BackEnd::gpu : BackEnd::cpu;
  options.precision = engine == "cpu64" ? Precision::float64 : Precision::float32;
  return options;
}

std::unique_ptr<HullCaster> openCaster(const std::string& engine,
                                       std::shared_ptr<const FlatScene> scene,
                                       const RenderOptions& options) {
  if (engine == "gpu") return makeGpuHullCaster(std::move(scene), options);
  if (isWitness(engine)) {
    return makeEmbreeHullCaster(*scene, engine == "embree", options.threads);
  }
  return makeCpuHullCaster(std::move(scene), options);
}

/// At most so many of the rays, evenly spaced.
std::vector<CastRay> thinned(const std::vector<CastRay>& rays, int most) {
  const auto limit = static_cast<std::size_t>(most);
  if (rays.size() <= limit) return rays;
  std::vector<CastRay> result;
  for (std::size_t i = 0; i < limit; ++i) result.push_back(rays[i * rays.size() / limit]);
  return result;
}

HullFacts factsOf(const FlatScene& scene, const std::string& strategy) {
  HullFacts facts;
  facts.strategy = strategy;
  facts.primitives = scene.index.boundedCount();
  if (scene.hulls == nullptr) return facts;
  const HullStructure& hulls = *scene.hulls;
  facts.nodes = hulls.nodeCount;
  facts.depth = hulls.depth;
  facts.buildSeconds = hulls.buildSeconds;
  facts.bytesPerPrimitive = static_cast<double>(hulls.bytes()) / std::max(facts.primitives, 1);
  facts.sahCost = hulls.sahCost;
  const Tightness tightness = tightnessOf(scene, hulls);
  facts.areaRatio = tightness.area;
  facts.volumeRatio = tightness.volume;
  return facts;
}

HullTotals totalsOf(const std::vector<HullCounts>& counts) {
  HullTotals totals;
  for (const HullCounts& each : counts) totals += each;
  return totals;
}

/// The rays of a kind, and what the first strategy answers to them.
struct RaySet {
  RayKind kind;
  std::vector<CastRay> rays;
  std::vector<HullHit> expected;  ///< by ray
};

/// A run with what it needs to be repeated.
struct Bench {
  HullRun run;
  const RaySet* set = nullptr;
  std::shared_ptr<HullCaster> caster;
};

void castOnce(Bench& bench, std::vector<HullHit>& hits) {
  hits.resize(bench.set->rays.size());
  bench.run.seconds.push_back(bench.caster->cast(bench.set->rays, hits));
}

std::size_t hitCount(const std::vector<HullHit>& hits) {
  return static_cast<std::size_t>(std::ranges::count_if(
      hits, [](const HullHit& hit) { return hit.primitive != layout::kNoPrimitive; }));
}

class Laboratory {
 public:
  Laboratory(const Scene& scene, const RenderOptions& options, const HullPlan& plan,
             const JobControl& control)
      : scene_(scene), options_(options), plan_(plan), control_(control) {}

  std::vector<HullRun> run() {
    drawRays();
    for (const std::string& engine : plan_.engines) measure(engine);
    std::vector<HullRun> runs;
    for (Bench& bench : benches_) runs.push_back(std::move(bench.run));
    return runs;
  }

 private:
  void drawRays() {
    RenderOptions options = engineOptions(options_, "cpu", "auto");
    const auto flat = flattenScene(scene_, options);
    for (const RayKind kind : plan_.kinds) {
      sets_.push_back({kind, thinned(sceneRays(flat, options, kind), plan_.mostRays), {}});
    }
  }

  void measure(const std::string& engine) {
    std::vector<std::size_t> added;
    // Native maths is each engine's own.
    for (RaySet& set : sets_) {
      if (options_.maths == Maths::native) set.expected.clear();
    }
    const std::vector<std::string> witness = {"embree"};
    for (const std::string& strategy : isWitness(engine) ? witness : plan_.strategies) {
      open(engine, strategy, added);
    }
    const std::size_t turns = added.size() * static_cast<std::size_t>(plan_.repeats);
    std::size_t done = 0;
    std::vector<HullHit> hits;
    for (int repeat = 0; repeat < plan_.repeats && !control_.stopRequested(); ++repeat) {
      for (const std::size_t i : added) {
        if (control_.stopRequested()) break;
        castOnce(benches_[i], hits);
        control_.report({static_cast<double>(++done) / static_cast<double>(turns), 0, 0.0});
      }
      std::ranges::reverse(added);
    }
    for (const std::size_t i : added) benches_[i].caster = nullptr;  // with its copy of the scene
  }

  /// Opens one strategy on an engine for every kind of rays; the trial run warms caches and is compared.
  void open(const std::string& engine, const std::string& strategy,
            std::vector<std::size_t>& added) {
    if (control_.stopRequested()) return;
    const RenderOptions options = engineOptions(options_, engine, strategy);
    const auto flat = flattenScene(scene_, options);
    const auto [known, isNew] = facts_.try_emplace(strategy);
    if (isNew) known->second = factsOf(*flat, strategy);
    const HullFacts& facts = known->second;
    HullRun run{scene_.name, facts, RayKind::primary, engine, options_.threads, 0, 0, 0, {}, {}, {}};
    std::shared_ptr<HullCaster> caster;
    try {
      caster = openCaster(engine, flat, options);
    } catch (const DeviceError& error) {
      run.missing = error.what();
    } catch (const UsageError& error) {
      run.missing = error.what();
    }
    if (caster == nullptr) {
      benches_.push_back({std::move(run), nullptr, nullptr});
      return;
    }
    for (RaySet& set : sets_) {
      run.kind = set.kind;
      benches_.push_back({run, &set, caster});
      try {
        tryOut(benches_.back(), set);
        added.push_back(benches_.size() - 1);
      } catch (const DeviceError& error) {
        benches_.back().run.missing = error.what();
      }
    }
  }

  static void tryOut(Bench& bench, RaySet& set) {
    std::vector<HullHit> hits(set.rays.size());
    bench.caster->cast(set.rays, hits);
    bench.run.rays = hits.size();
    bench.run.hits = hitCount(hits);
    bench.run.totals = totalsOf(bench.caster->count(set.rays));
    if (bench.run.engine == "cpu64" || isWitness(bench.run.engine)) return;  // round otherwise
    if (set.expected.empty()) set.expected = hits;
    for (std::size_t i = 0; i < hits.size(); ++i) {
      if (hits[i] != set.expected[i]) ++bench.run.differing;
    }
  }

  const Scene& scene_;
  const RenderOptions& options_;
  const HullPlan& plan_;
  const JobControl& control_;
  std::vector<RaySet> sets_;
  std::vector<Bench> benches_;
  std::map<std::string, HullFacts> facts_;  ///< by strategy: the same on every engine
};

template <class Name>
void checkNames(const char* what, const std::vector<std::string>& given,
                const std::vector<Name>& known) {
  for (const std::string& name : given) {
    if (std::ranges::find(known, name) != known.end()) continue;
    throw UsageError(std::string(what) + ": found " + quote(name) + ", expected " + oneOf(known) +
                     didYouMean(name, known));
  }
}

}  // namespace

double HullRun::bestSeconds() const {
  return seconds.empty() ? 0.0 : *std::ranges::min_element(seconds);
}

double HullRun::medianSeconds() const {
  if (seconds.empty()) return 0.0;
  std::vector<double> sorted = seconds;
  std::ranges::sort(sorted);
  const std::size_t half = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[half] : 0.5 * (sorted[half - 1] + sorted[half]);
}

std::vector<HullRun> measureHulls(const Scene& scene, const RenderOptions& options,
                                  const HullPlan& plan, const JobControl& control) {
  std::vector<std::string> strategies;
  for (const HullStrategy& strategy : hullStrategies()) strategies.push_back(strategy.name);
  checkNames("strategies", plan.strategies, strategies);
  checkNames("engines", plan.engines, kHullEngines);
  return Laboratory(scene, options, plan, control).run();
}

std::vector<HullCounts> primaryCounts(const Scene& scene, const RenderOptions& options,
                                      const std::string& strategy) {
  const RenderOptions chosen = engineOptions(options, "cpu", strategy);
  const auto flat = flattenScene(scene, chosen);
  return makeCpuHullCaster(flat, chosen)->count(sceneRays(flat, chosen, RayKind::primary));
}

}  // namespace twintrace
