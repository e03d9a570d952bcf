#include "automata_commands.h"

#include <algorithm>
#include <chrono>
#include <iostream>

#include <fmt/format.h>

#include "cobot_command/automata/canonical.h"
#include "cobot_command/automata/formats.h"
#include "cobot_command/automata/oracle.h"
#include "cobot_command/automata/supervisor.h"
#include "cobot_command/automata/verification.h"
#include "cobot_command/cell/schedule/oracle.h"
#include "cobot_command/runtime/cell/cell_files.h"

namespace cobot_command::tools {

using runtime::readArtifact;
using runtime::readFile;
using runtime::writeFile;
namespace {

constexpr std::size_t kMaxStates = 5000000;

/// A stage of each problem: how many figures are the same, and each that is not.
void addFigures(const std::vector<automata::OracleFigure>& figures, Answer& answer) {
  for (const auto& figure : figures) {
    const bool is_known = !answer.stages.empty() && answer.stages.back().name == figure.problem;
    if (!is_known) answer.stages.push_back({figure.problem, 0.0, {}, {}});
    if (figure.isSame()) {
      answer.stages.back().report.push_back(fmt::format("{} {}", figure.figure, figure.found));
    } else {
      answer.stages.back().faults.push_back(fmt::format("{}: {} is {}, and should be {}", figure.problem,
                                                        figure.figure, figure.found, figure.expected));
    }
  }
}

AnswerStage synthesized(const automata::Problem& problem) {
  const auto begin = Clock::now();
  AnswerStage stage{problem.name.empty() ? "problem" : problem.name, 0.0, {}, {}};
  const automata::Composition composition(problem);
  const auto space = automata::StateSpace::explore(composition, kMaxStates);
  if (!space) {
    stage.faults.push_back(fmt::format("there are more than {} states", kMaxStates));
    return stage;
  }
  const automata::Synthesis synthesis(*space);
  if (synthesis.empty()) {
    std::vector<std::string> names;
    for (const auto event : shortestWayIntoConflict(*space)) names.push_back(problem.events[event].name);
    stage.faults.push_back(fmt::format("there is no supervisor; the shortest sequence into a conflict: {}",
                                       fmt::join(names, " ")));
    return stage;
  }
  const auto& counts = synthesis.counts();
  const std::string fingerprint =
      canonicalFormOf(automatonOf(synthesis, problem), problem.events).fingerprint(problem.events);
  stage.faults = automata::verify(compile(synthesis, problem), fingerprint, {}, {kMaxStates}).faults;
  stage.report.push_back(fmt::format(
      "{} states, {} transitions; avoids {} states; refuses {} by specs, {} beyond", counts.states,
      counts.transitions, counts.frontier, counts.refused_by_spec, counts.refused_beyond_spec));
  stage.report.push_back("fingerprint " + fingerprint);
  stage.seconds = secondsSince(begin);
  return stage;
}

std::string written(const automata::Problem& problem, const std::string& format) {
  if (format == "wmod") return automata::toWmod(problem);
  if (format == "cif") return automata::toCif(problem);
  if (format == "dot") return automata::toDot(problem);
  return automata::toJson({problem});
}

}  // namespace

Answer compareOracles(const std::string& file) {
  const auto text = readFile(file);
  if (!text) return wrong("oracle", text.error());
  const auto begin = Clock::now();
  const auto figures = automata::compareWithOracles(*text);
  if (!figures) return wrong("oracle", file + ": " + figures.error());
  const auto schedules = cell::compareSchedulesWithOracles(*text);
  if (!schedules) return wrong("oracle", file + ": " + schedules.error());
  Answer answer;
  addFigures(*figures, answer);
  Answer of_schedules;
  addFigures(*schedules, of_schedules);
  for (AnswerStage& stage : of_schedules.stages) {
    stage.name += ", schedule";
    answer.stages.push_back(std::move(stage));
  }
  const auto all = figures->size() + schedules->size();
  answer.stages.push_back(
      {"oracle", secondsSince(begin), {fmt::format("{} figures were compared", all)}, {}});
  return answer;
}

Answer exportAutomata(const std::string& artifact_file, const std::string& format,
                      const std::string& output) {
  const auto artifact = readArtifact(artifact_file);
  if (!artifact) return {{{"export", 0.0, {}, artifact.error()}}};
  const auto model = cell::modelOf(artifact->program);
  if (!model) return {{{"export", 0.0, {}, model.error()}}};
  const std::string text = written(model->problem, format);
  if (output.empty()) {
    std::cout << text;
    return {};
  }
  return {{{"export", 0.0, {output}, writeFile(output, text, artifact_file)}}};
}

Answer importAutomata(const std::string& file) {
  const auto text = readFile(file);
  if (!text) return wrong("import", text.error());
  const bool is_json = text->find_first_not_of(" \t\r\n") != std::string::npos &&
                       (*text)[text->find_first_not_of(" \t\r\n")] == '{';
  std::vector<automata::Problem> problems;
  if (is_json) {
    auto read = automata::problemsFromJson(*text);
    if (!read) return wrong("import", file + ": " + read.error());
    problems = std::move(*read);
  } else {
    auto read = automata::problemFromWmod(*text);
    if (!read) return wrong("import", file + ": " + read.error());
    problems.push_back(std::move(*read));
  }
  Answer answer;
  for (const automata::Problem& problem : problems) answer.stages.push_back(synthesized(problem));
  return answer;
}

}  // namespace cobot_command::tools
