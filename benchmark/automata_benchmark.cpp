// What deciding costs: the synthesis of rings, and one decision while they run (cell.md, P3 and P4).
#include <random>

#include "cell_problems.h"
#include <benchmark/benchmark.h>

#include "cobot_command/automata/compression.h"
#include "cobot_command/automata/safe_order.h"
#include "cobot_command/automata/supervisor.h"
#include "cobot_command/automata/synthesis.h"

namespace cobot_command::automata {
namespace {

constexpr std::size_t kMaxStates = 5000000;

void synthesis(benchmark::State& run) {
  const Problem problem = test_support::ring(static_cast<int>(run.range(0)));
  double states = 0;
  for (auto _ : run) {
    const Composition composition(problem);
    const auto space = StateSpace::explore(composition, kMaxStates);
    const Synthesis result(*space);
    states += static_cast<double>(result.counts().states);
  }
  run.counters["states_per_s"] = benchmark::Counter(states, benchmark::Counter::kIsRate);
}
BENCHMARK(synthesis)->DenseRange(6, 8)->Unit(benchmark::kMillisecond);

/// Decisions on the events of a run by chance.
template <class Rule>
void decide(benchmark::State& run, const Rule& rule, std::size_t events) {
  std::mt19937 chance(1);
  Tuple state = rule.initial();
  for (auto _ : run) {
    const auto event = static_cast<EventIndex>(chance() % events);
    Decision decision = rule.decide(state, event);
    if (decision.verdict == Decision::Verdict::Granted) state = std::move(decision.next);
  }
}

void decisionByFrontier(benchmark::State& run) {
  const Problem problem = test_support::ring(6);
  const Composition composition(problem);
  const auto space = StateSpace::explore(composition, kMaxStates);
  decide(run, Supervisor(compile(Synthesis(*space), problem)), problem.events.size());
}
BENCHMARK(decisionByFrontier);

void decisionBySafeOrder(benchmark::State& run) {
  const Problem problem = test_support::ring(static_cast<int>(run.range(0)));
  decide(run, SafeOrder(problem), problem.events.size());
}
BENCHMARK(decisionBySafeOrder)->Arg(3)->Arg(32);

/// The worst that there is: a booking in a state where all robots are on their way.
void safeOrderHome(benchmark::State& run) {
  const Problem problem = test_support::ring(static_cast<int>(run.range(0)));
  const SafeOrder rule(problem);
  Tuple state = rule.initial();
  for (EventIndex event = 0; event < problem.events.size(); ++event) {
    if (event % 8 > 1) continue;
    Decision decision = rule.decide(state, event);
    if (decision.verdict == Decision::Verdict::Granted) state = std::move(decision.next);
  }
  for (auto _ : run) benchmark::DoNotOptimize(rule.isSafe(state));
}
BENCHMARK(safeOrderHome)->Arg(32);

}  // namespace
}  // namespace cobot_command::automata
