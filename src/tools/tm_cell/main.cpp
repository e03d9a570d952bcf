// tm_cell: from the file of a cell to a verified artifact, and what it decides. No ROS.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "../command_line.h"
#include "../whole_number.h"
#include "../written_output.h"
#include "answer.h"
#include "ask_command.h"
#include "automata_commands.h"
#include "build_commands.h"
#include "cover_command.h"
#include "decision_commands.h"
#include "simulate_command.h"
#include "voxels_command.h"
#include <CLI/CLI.hpp>

#include "cobot_command/common/foreign_text.h"

namespace {

using namespace cobot_command::tools;
using cobot_command::cell::BuildStage;

constexpr const char* kFile = "FILE";  // as help names what is one
/// Room for the numbers that are made of it by counting on.
constexpr std::int64_t kMostSeed = 999999999;

/// Beside a range, which a NaN is neither below nor above.
CLI::Validator isNumber() {
  return CLI::Validator(
      [](std::string& text) {
        return std::isnan(std::strtod(text.c_str(), nullptr)) ? text + " is not a number" : std::string();
      },
      "");
}

/// Of a file: an empty name is a variable of the shell that was not set.
CLI::Validator isNamed() {
  return CLI::Validator(
      [](std::string& text) { return text.empty() ? std::string("the name is empty") : std::string(); }, "");
}

/// What the words of the command line set.
struct Given {
  bool json = false;
  BuildOptions build;
  std::string policy = "supervisor";
  std::string artifact;
  SimulateOptions simulate;
  std::string cell_file;
  std::string event;
  std::vector<std::string> happened;
  double seconds = 10.0;
  CoverOptions cover;
  VoxelsOptions voxels;
  AskOptions ask;
  std::string file;
  std::string format;
  std::string output;
};

/// A command, and what it answers.
struct Command {
  CLI::App* app = nullptr;
  std::function<Answer()> run;
};

class Commands {
 public:
  explicit Commands(CLI::App& app) : app_(app) {
    addCell("check", "Read a cell file and list all errors in it",
            [this] { return checkCell(given_.build.cell_file); });
    addStage("sweep", "Plan all steps, and calculate the space that the robots can occupy",
             BuildStage::Sweep);
    addStage("zones", "Find the zones that robots share, and check that they are sufficient",
             BuildStage::Soundness);
    addStage("instrument", "Derive events and automata from the programs", BuildStage::Instrument);
    addStage("synthesize", "Synthesize the supervisor", BuildStage::Synthesize);
    CLI::App* build = addStage(
        "build", "Run all these stages and write the verified result into one artifact", BuildStage::Verify);
    build->add_option("-o,--output", given_.build.output, "The artifact")
        ->type_name(kFile)
        ->required()
        ->check(isNamed());
    addArtifactCommands();
    addAutomataCommands();
    addCover();
    addVoxels();
  }

  Answer run() {
    given_.build.policy = cobot_command::cell::policyNamed(given_.policy).value_or(given_.build.policy);
    for (const Command& command : commands_) {
      if (command.app->parsed()) return command.run();
    }
    return {};
  }
  [[nodiscard]] bool json() const { return given_.json; }

 private:
  CLI::App* add(const std::string& name, const std::string& description, std::function<Answer()> run) {
    CLI::App* command = app_.add_subcommand(name, description);
    command->add_flag("--json", given_.json, "One line of JSON instead of text");
    commands_.push_back({command, std::move(run)});
    return command;
  }

  CLI::App* addCell(const std::string& name, const std::string& description, std::function<Answer()> run) {
    CLI::App* command = add(name, description, std::move(run));
    command->add_option("CELL", given_.build.cell_file, "Cell file, as in config/cells")
        ->type_name(kFile)
        ->required();
    return command;
  }

  CLI::App* addStage(const std::string& name, const std::string& description, BuildStage last) {
    CLI::App* command = addCell(name, description, [this, last] { return buildCell(given_.build, last); });
    command
        ->add_option("--policy", given_.policy,
                     "Policy of the decisions: supervisor, or safe_order, which needs no table of states")
        ->check(CLI::IsMember({"supervisor", "safe_order"}));
    given_.build.threads = std::max(1U, std::thread::hardware_concurrency());
    command
        ->add_option("--threads", given_.build.threads, "Number of threads for sweeping robots in parallel")
        ->transform(isWhole(1, 64));
    return command;
  }

  CLI::App* addArtifact(const std::string& name, const std::string& description,
                        std::function<Answer()> run) {
    CLI::App* command = add(name, description, std::move(run));
    command->add_option("ARTIFACT", given_.artifact, "Artifact that build has written")
        ->type_name(kFile)
        ->required();
    return command;
  }

  void addArtifactCommands() {
    addArtifact("verify", "Verify an artifact again, from its bytes",
                [this] {
                  return verifyArtifact(given_.artifact, given_.cell_file,
                                        std::max(1U, std::thread::hardware_concurrency()));
                })
        ->add_option("--cell", given_.cell_file,
                     "Cell file that the artifact must be made from, byte by byte")
        ->type_name(kFile)
        ->check(isNamed());
    CLI::App* explain = addArtifact("explain", "Whether an event is granted; if not, why", [this] {
      return explainEvent(given_.artifact, given_.happened, given_.event);
    });
    explain->add_option("EVENT", given_.event, "Name of the event, for example RA_b_Z1")->required();
    explain
        ->add_option("--behind", given_.happened, "Events since all robots were at home, separated by commas")
        ->delimiter(',');
    addArtifact("rules", "States that the supervisor avoids, as rules over few robots",
                [this] { return tellRules(given_.artifact); });
    CLI::App* schedule = addArtifact("schedule", "The shortest cycle of all robots",
                                     [this] { return scheduleCell(given_.artifact, given_.seconds); });
    schedule->add_option("--seconds", given_.seconds, "Time limit of the search")
        ->check(CLI::Range(0.001, 86400.0))
        ->check(isNumber());
    addSimulate();
    addAsk();
    CLI::App* exported = addArtifact("export", "Export the automata for other programs", [this] {
      return exportAutomata(given_.artifact, given_.format, given_.output);
    });
    exported->add_option("FORMAT", given_.format, "wmod, cif, dot or json")
        ->required()
        ->check(CLI::IsMember({"wmod", "cif", "dot", "json"}));
    exported->add_option("-o,--output", given_.output, "Output file; default: standard output")
        ->type_name(kFile);
  }

  void addSimulate() {
    SimulateOptions& options = given_.simulate;
    CLI::App* simulate = addArtifact(
        "simulate", "Run all robots, simulated controllers and the supervisor in simulated time", [this] {
          given_.simulate.artifact = given_.artifact;
          given_.simulate.policy = given_.policy;
          return simulateCell(given_.simulate);
        });
    simulate
        ->add_option(
            "--policy", given_.policy,
            "supervisor, safe_order, schedule; or, to see the effect of missing supervision: mutex, none")
        ->check(CLI::IsMember({"supervisor", "safe_order", "schedule", "mutex", "none"}));
    simulate->add_option("--cycles", options.cycles, "Cycles of each robot")->transform(isWhole(1, 1000000));
    simulate->add_option("--seed", options.seed, "The same seed gives the same run")
        ->transform(isWhole(0, kMostSeed));
    simulate->add_flag("--random", options.is_random,
                       "Random project speeds, pauses, and delays of messages");
    simulate->add_option("--loss", options.loss, "Percentage of messages that are lost")
        ->check(CLI::Range(0.0, 90.0))
        ->check(isNumber());
    simulate->add_flag("--quiet", options.is_quiet, "Print only the result");
  }

  void addAsk() {
    CLI::App* ask =
        addArtifact("ask", "Print one value of an artifact, for launch files and scripts", [this] {
          given_.ask.artifact = given_.artifact;
          return askArtifact(given_.ask);
        });
    ask->add_option("WHAT", given_.ask.what,
                    "robots, mechanisms, speed [%]; or of one of them: model, urdf, tcp [mm, deg], home "
                    "[deg; m or rad], places")
        ->required()
        ->check(CLI::IsMember({"robots", "mechanisms", "speed", "model", "urdf", "tcp", "home", "places"}));
    ask->add_option("ROBOT", given_.ask.robot, "Name of the robot or mechanism");
  }

  void addAutomataCommands() {
    add("import", "Synthesize and verify automata of another program",
        [this] { return importAutomata(given_.file); })
        ->add_option("FILE", given_.file, "A module of Supremica (.wmod), or JSON of this package")
        ->type_name(kFile)
        ->required();
    add("oracle", "Compare with figures from independent programs",
        [this] { return compareOracles(given_.file); })
        ->add_option("FILE", given_.file, "A file such as test/data/cell-oracles.json")
        ->type_name(kFile)
        ->required();
  }

  void addCover() {
    CLI::App* cover = add("cover", "Boxes that cover a mesh, as shapes of a cell file",
                          [this] { return coverMesh(given_.cover); });
    cover->add_option("FILE", given_.cover.mesh, "An STL file, text or binary")->type_name(kFile)->required();
    cover->add_option("--cell", given_.cover.cell, "The boxes consist of cells with this edge [mm]")
        ->check(CLI::Range(1.0, 1000.0))
        ->check(isNumber());
    cover->add_option("--scale", given_.cover.scale, "Millimetres per unit of the file: 1000 for metres")
        ->check(CLI::Range(1e-6, 1e6))
        ->check(isNumber());
    cover->add_option("-o,--output", given_.cover.output, "Output file; default: standard output")
        ->type_name(kFile);
  }

  void addVoxels() {
    CLI::App* voxels = addCell("voxels", "Write zones and claims as files for viewers", [this] {
      given_.voxels.cell_file = given_.build.cell_file;
      given_.voxels.threads = std::max(1U, std::thread::hardware_concurrency());
      return writeVoxels(given_.voxels);
    });
    voxels
        ->add_option("-o,--output", given_.voxels.folder, "Output folder; it is created if it does not exist")
        ->type_name("FOLDER")
        ->required();
    voxels
        ->add_option("--format", given_.voxels.format,
                     "ply: point clouds of the centres [m]; bt: maps of OctoMap")
        ->check(CLI::IsMember({"ply", "bt"}));
  }

  CLI::App& app_;
  Given given_;
  std::vector<Command> commands_;
};

int run(int argc, char** argv) {
  CLI::App app("Cells of several robots: swept zones and verified supervisors");
  nameProgram(app, "tm_cell");
  app.footer("Exit status: 0 yes, 1 no, 2 bad usage, 3 the answer could not be written.");
  Commands commands(app);
  askForSubcommand(app);
  if (const auto end = readCommandLine(app, wordsOf(argc, argv))) return *end;
  return print(commands.run(), commands.json());
}

}  // namespace

int main(int argc, char** argv) try {
  return cobot_command::tools::unlessOutputLost("tm_cell", run(argc, argv));
} catch (const std::exception& error) {
  std::fprintf(stderr, "tm_cell: %s\n", cobot_command::forPeople(error.what()).c_str());
  return cobot_command::tools::kNo;
}
