// Parameters of both nodes that cannot be used: refused by name, before anything is made of them. No master
// is needed: they are given as the parameter server would have them.
#include <limits>

#include "settings_page.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "cobot_command/arm/urdf_prefix.h"
#include "cobot_command/common/units.h"
#include "cobot_command/ros/command/command_parameters.h"
#include "cobot_command/ros/mechanism/mechanism_node.h"
#include "cobot_command/ros/simulation/simulator_parameters.h"
#include "cobot_command/ros/supervision/supervisor_parameters.h"

namespace cobot_command::ros_adapter {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

GivenParameters ofNode(const GivenValues& values) {
  return {"/robot/node", values, std::nullopt};
}
/// What the node says before it ends; "" when it starts.
std::string refusalOfCommandNode(const GivenParameters& given) {
  const auto parameters = readCommandParameters(given);
  return parameters ? "" : parameters.error().message;
}
std::string refusalOfSimulator(GivenParameters given) {
  given.own.emplace("robot_model", Given{"tm5-900"});
  const auto parameters = readSimulatorParameters(given);
  return parameters ? "" : parameters.error().message;
}

/// What no setting of the form can be.
std::vector<Given> badFor(const SettingKind& kind) {
  using Form = SettingKind::Form;
  std::vector<Given> bad{{OtherKind{"a date"}}, {OtherKind{"binary data"}}, {GivenList{{"x"}, {7}, {true}}}};
  if (kind.form == Form::Number) {
    for (const double number : {kNan, kInfinity, -kInfinity, -1e9, 1e300}) bad.push_back({number});
    for (const char* text : {"", "x"}) bad.push_back({text});
    bad.push_back({true});
  } else if (kind.form == Form::Flag) {
    bad.insert(bad.end(), {{2}, {-1}, {0.0}, {"yes"}, {""}, {kNan}});
  } else if (kind.form == Form::Text) {
    bad.insert(bad.end(), {{true}, {5}, {GivenList{}}});
  } else {
    bad.insert(bad.end(), {{true}, {5}, {"x"}, {kNan}, {GivenList{{kNan}}}, {GivenList{{GivenList{}}}}});
  }
  if (kind.type == "a whole number") bad.insert(bad.end(), {{7.5}, {1.0}, {2147483647}});
  return bad;
}

/// Every bad value of every row: refused, with the name of the parameter and with what is allowed.
template <class Refusal>
int tryAll(const SettingTable& table, const Refusal& refusal) {
  int tried = 0;
  for (const Setting& setting : table) {
    for (const Given& given : badFor(setting.kind)) {
      const std::string message = refusal(ofNode({{setting.name, given}}));
      EXPECT_THAT(message, HasSubstr(fmt::format("parameter /robot/node/{} ", setting.name)))
          << describe(given);
      EXPECT_THAT(message, HasSubstr("; allowed: " + allowedBy(setting.kind)));
      ++tried;
    }
  }
  return tried;
}

TEST(ParametersOfTheCommandNode, areRefusedByNameWhateverTheyAre) {
  CommandParameters parameters;
  EXPECT_GE(tryAll(settingsTable(parameters), refusalOfCommandNode), 200);
}

TEST(ParametersOfTheSimulator, areRefusedByNameWhateverTheyAre) {
  SimulatorNodeSetup setup;
  EXPECT_GE(tryAll(settingsTable(setup), refusalOfSimulator), 200);
}

TEST(ParametersOfTheCommandNode, haveDefaults) {
  const auto parameters = readCommandParameters(ofNode({}));
  ASSERT_TRUE(parameters) << parameters.error().message;
  EXPECT_THAT(parameters->warnings, IsEmpty());
  EXPECT_FALSE(parameters->arm);
  EXPECT_EQ(parameters->script_port, 5890);
  EXPECT_EQ(parameters->diagnostic_period, 1.0);
}

TEST(ParametersOfTheCommandNode, canAllBeSet) {
  const auto parameters = readCommandParameters(ofNode({{"robot_ip", {"10.0.0.7"}},
                                                        {"script_port", {7001}},
                                                        {"status_port", {7002}},
                                                        {"robot_model", {"tm12"}},
                                                        {"prefix", {"left_"}},
                                                        {"turn_speed", {90}},
                                                        {"evidence_timeout", {0.75}},
                                                        {"position_tolerance", {0.002}},
                                                        {"angle_tolerance", {0.01}},
                                                        {"open_timeout", {3}},
                                                        {"retry_min", {0.2}},
                                                        {"retry_max", {0.2}},
                                                        {"reply_timeout", {0.5}},
                                                        {"supervision_period", {0.25}},
                                                        {"supervision_misses", {5}},
                                                        {"status_timeout", {2}},
                                                        {"tag_deadline_factor", {2}},
                                                        {"tag_deadline_margin", {3}},
                                                        {"unplanned_motion_timeout", {60}},
                                                        {"stop_timeout", {4}},
                                                        {"auto_connect", {true}},
                                                        {"auto_reconnect", {true}},
                                                        {"stop_orphaned_motion", {false}},
                                                        {"path_in_manual_mode", {true}},
                                                        {"simulated_controller", {"/cell/simulator"}},
                                                        {"diagnostic_period", {0.5}},
                                                        {"tf_from_start", {false}}}));
  ASSERT_TRUE(parameters) << parameters.error().message;
  using namespace std::chrono_literals;
  const link::LinkSettings& link = parameters->link;
  EXPECT_EQ(parameters->robot_ip, "10.0.0.7");
  EXPECT_EQ(parameters->script_port, 7001);
  EXPECT_EQ(link.status_port, 7002);
  EXPECT_EQ(parameters->arm->name(), "tm12");
  EXPECT_EQ(parameters->prefix, "left_");
  EXPECT_EQ(link.open_timeout, 3s);
  EXPECT_EQ(link.retry_min, 200ms);
  EXPECT_EQ(link.retry_max, 200ms);
  EXPECT_EQ(link.reply_timeout, 500ms);
  EXPECT_EQ(link.supervision_period, 250ms);
  EXPECT_EQ(link.supervision_misses, 5);
  EXPECT_EQ(link.status_timeout, 2s);
  EXPECT_EQ(link.tag_deadline_factor, 2);
  EXPECT_EQ(link.tag_deadline_margin, 3s);
  EXPECT_EQ(link.unplanned_motion_timeout, 60s);
  EXPECT_EQ(link.stop_timeout, 4s);
  EXPECT_EQ(link.evidence_timeout, 750ms);
  EXPECT_EQ(link.position_tolerance, 0.002);
  EXPECT_EQ(link.angle_tolerance, 0.01);
  EXPECT_DOUBLE_EQ(parameters->arm->ratings().turn_speed, degToRad(90));
  EXPECT_TRUE(parameters->auto_connect && link.auto_reconnect && link.path.in_manual_mode);
  EXPECT_FALSE(link.stop_orphaned_motion || parameters->tf_from_start);
  EXPECT_EQ(parameters->simulated_controller, "/cell/simulator");
  EXPECT_EQ(parameters->diagnostic_period, 0.5);
}

struct Refused {
  GivenValues values;
  std::string words;
};

TEST(ParametersOfTheCommandNode, haveToMakeSense) {
  const std::vector<Refused> rows{
      {{{"simulated_controller", {"a b"}}},
       "simulated_controller is the text \"a b\"; allowed: the name of a"},
      {{{"simulated_controller", {"~sim"}}}, "simulated_controller is"},
      {{{"simulated_controller", {"1sim"}}}, "simulated_controller is"},
      {{{"simulated_controller", {"sim\xc3\xbc"}}}, "simulated_controller is the text \"sim\xc3\xbc\""},
      {{{"diagnostic_period", {0.0}}}, "diagnostic_period is 0.0; allowed: a number, 0.1 to 3600 s"},
      {{{"script_port", {5890.7}}}, "script_port is 5890.7; allowed: a whole number, 0 to 65535"},
      {{{"script_port", {"5890"}}}, "script_port is the text \"5890\"; allowed: a whole number, 0 to 65535"},
      {{{"supervision_misses", {2.5}}}, "supervision_misses is 2.5; allowed: a whole number, 1 to 100"},
      {{{"supervision_misses", {0}}}, "supervision_misses is 0"},
      {{{"retry_min", {2}}, {"retry_max", {1}}}, "retry_min is 2 s, more than retry_max, which is 1 s"},
      {{{"retry_min", {1.5}}}, "retry_min is 1.5 s, more than retry_max, which is 1 s"},
      {{{"prefix", {"/x"}}}, "prefix is the text \"/x\"; allowed: letters, digits, _, -, . and /, not beg"},
      {{{"prefix", {"a b"}}}, "prefix is the text \"a b\""},
      {{{"prefix", {"a\n"}}}, "prefix is the text \"a\\n\""},
      {{{"robot_model", {"TM12"}}}, "robot_model is the text \"TM12\"; allowed: tm5-700, tm5-900, tm12"},
      {{{"robot_ip", {"10.0.0.7 "}}},
       "robot_ip is the text \"10.0.0.7 \"; allowed: a host name or address without blanks"},
      {{{"robot_ip", {std::string(256, 'a')}}}, "robot_ip is"},
      {{{"auto_connect", {true}}},
       "robot_ip is empty; allowed: the controller's address, because auto_connect"},
      {{{"auto_connect", {true}}, {"robot_ip", {"h"}}, {"script_port", {0}}},
       "script_port is 0; allowed: the"},
      {{{"status_port", {5890}}}, "status_port is 5890, the same as script_port"},
  };
  for (const Refused& row : rows) {
    EXPECT_THAT(refusalOfCommandNode(ofNode(row.values)), HasSubstr("parameter /robot/node/" + row.words));
  }
}

TEST(ParametersOfTheSimulator, haveToMakeSense) {
  const std::vector<Refused> rows{
      {{{"publish_rate", {kInfinity}}}, "publish_rate is inf; allowed: a number, 0.1 to 1000 Hz"},
      {{{"prefix", {"/x"}}}, "prefix is the text \"/x\""},
      {{{"variables", {GivenList{{"int PTP"}}}}}, "variables holds \"int PTP\": PTP is a function"},
      {{{"points", {GivenList{{"P=0,0,170,0,0,0"}}}}}, "points \"P\" has joint 3 at 170 deg"},
      {{{"status_port", {5890}}}, "status_port is 5890, the same as script_port"},
  };
  for (const Refused& row : rows) {
    EXPECT_THAT(refusalOfSimulator(ofNode(row.values)), HasSubstr("parameter /robot/node/" + row.words));
  }
  EXPECT_EQ(refusalOfSimulator(ofNode({})), "");
  EXPECT_THAT(readSimulatorParameters(ofNode({})).error().message,
              HasSubstr("robot_model is empty, and there is no robot_description"));
}

TEST(Parameters, areWarnedOfWhenTheyAreMisspelt) {
  const auto commanding = readCommandParameters(ofNode({{"scrip_port", {7000}}, {"colour", {"red"}}}));
  ASSERT_TRUE(commanding);
  EXPECT_THAT(commanding->warnings, ElementsAre("parameter /robot/node/colour is not a parameter of this "
                                                "node and is ignored: doc/parameters.md lists its parameters",
                                                "parameter /robot/node/scrip_port is not a parameter of this "
                                                "node and is ignored: did you mean script_port?"));
  const auto simulated = readSimulatorParameters(
      ofNode({{"robot_model", {"tm12"}}, {"project_sped", {50}}, {"listening", {OtherKind{"a namespace"}}}}));
  ASSERT_TRUE(simulated) << simulated.error().message;
  ASSERT_EQ(simulated->warnings.size(), 1U);
  EXPECT_THAT(simulated->warnings.front(), HasSubstr("did you mean project_speed?"));
}

class Described : public ::testing::Test {
 protected:
  static std::string urdf(const std::string& model, const std::string& prefix = {}) {
    return arm::withPrefix(arm::ArmModel::urdfOf(model), prefix).value();
  }
  static GivenParameters given(const GivenValues& values, const Given& description) {
    return {"/robot/node", values, description};
  }
};

TEST_F(Described, givesTheModelThatIsNotNamed) {
  const auto parameters = readCommandParameters(given({{"prefix", {"left_"}}}, {urdf("tm12", "left_")}));
  ASSERT_TRUE(parameters) << parameters.error().message;
  EXPECT_EQ(parameters->arm->name(), "tm12");
  EXPECT_THAT(parameters->warnings, IsEmpty());
}

TEST_F(Described, mustNotBeAnotherModelThanTheOneThatIsNamed) {
  EXPECT_THAT(
      refusalOfCommandNode(given({{"robot_model", {"tm5-900"}}}, {urdf("tm12")})),
      HasSubstr("robot_model is tm5-900, but robot_description describes a tm12; allowed: the same model"));
  EXPECT_EQ(refusalOfCommandNode(given({{"robot_model", {"tm12"}}}, {urdf("tm12")})), "");
}

TEST_F(Described, isWarnedOfWhenItHasOtherLengthsOrNames) {
  std::string longer = urdf("tm5-900");
  const std::size_t place = longer.find("velocity=\"");
  ASSERT_NE(place, std::string::npos);
  longer.replace(place, 11, "velocity=\"1");
  const auto other = readCommandParameters(given({{"robot_model", {"tm5-900"}}}, {longer}));
  ASSERT_TRUE(other) << other.error().message;
  EXPECT_THAT(other->warnings, ElementsAre(HasSubstr("its nominal lengths and limits are used")));
  const auto prefixed = readCommandParameters(given({{"robot_model", {"tm5-900"}}}, {urdf("tm5-900", "a_")}));
  ASSERT_TRUE(prefixed);
  EXPECT_THAT(prefixed->warnings, ElementsAre(HasSubstr("in robot_description it is \"a_")));
}

TEST_F(Described, mayBeAnythingWhenTheModelIsNamed) {
  for (const Given& description : {Given{"<robot name='cell'/>"}, Given{""}, Given{7}}) {
    const auto parameters = readCommandParameters(given({{"robot_model", {"tm12"}}}, description));
    ASSERT_TRUE(parameters) << parameters.error().message;
    EXPECT_THAT(parameters->warnings, IsEmpty());
  }
}

TEST_F(Described, mustBeUsableWhenItIsNot) {
  for (const Given& description :
       {Given{"<robot name='cell'/>"}, Given{""}, Given{7}, Given{OtherKind{"binary data"}}}) {
    EXPECT_THAT(refusalOfCommandNode(given({}, description)),
                ::testing::MatchesRegex(
                    ".*robot_model is empty, and robot_description (cannot be used|is 7|is binary data).*"));
  }
}

TEST(ParametersOfTheCommandNode, areThePortsThatASimulatedControllerTells) {
  CommandParameters parameters;
  EXPECT_EQ(takeAnnounced({{"script_port", {40001}}, {"status_port", {40002}}}, parameters), std::nullopt);
  EXPECT_EQ(parameters.script_port, 40001);
  EXPECT_EQ(parameters.link.status_port, 40002);
}

TEST(ParametersOfTheCommandNode, areNoPortsOnWhichNobodyCanListen) {
  const auto refusal = [](const Given& script, const Given& status) {
    CommandParameters parameters;
    parameters.simulated_controller = "/sim";
    const auto fault = takeAnnounced({{"script_port", script}, {"status_port", status}}, parameters);
    return fault ? fault->setting + ' ' + describe(*fault) : "";
  };
  EXPECT_THAT(
      refusal({70000}, {40002}),
      HasSubstr("simulated_controller is /sim, whose listening/script_port is 70000; allowed: a whole "
                "number, 1 to 65535"));
  EXPECT_THAT(refusal({40001}, {0}), HasSubstr("listening/status_port is 0"));
  EXPECT_THAT(refusal({-1}, {40002}), HasSubstr("listening/script_port is -1"));
  EXPECT_THAT(refusal({"40001"}, {40002}), HasSubstr("listening/script_port is the text \"40001\""));
  EXPECT_THAT(refusal({40001}, {40002.5}), HasSubstr("listening/status_port is 40002.5"));
  EXPECT_THAT(refusal({40001}, {40001}),
              HasSubstr("listening/status_port is 40001, the same as script_port"));
}

TEST(ParameterServer, hasValuesOfAllTypes) {
  XmlRpc::XmlRpcValue list;
  list[0] = 1;
  list[1] = "x";
  list[2] = 2.5;
  XmlRpc::XmlRpcValue map;
  map["a"] = true;
  tm date{};
  char bytes[] = "ab";
  EXPECT_EQ(describe(toGiven(XmlRpc::XmlRpcValue(true))), "true");
  EXPECT_EQ(describe(toGiven(XmlRpc::XmlRpcValue(5890))), "5890");
  EXPECT_EQ(describe(toGiven(XmlRpc::XmlRpcValue(5890.0))), "5890.0");
  EXPECT_EQ(describe(toGiven(XmlRpc::XmlRpcValue("5890"))), "the text \"5890\"");
  EXPECT_EQ(describe(toGiven(list)), "a list of 3");
  EXPECT_EQ(std::get<double>(std::get<GivenList>(toGiven(list).value)[2].value), 2.5);
  EXPECT_EQ(describe(toGiven(map)), "a namespace with parameters");
  EXPECT_EQ(describe(toGiven(XmlRpc::XmlRpcValue(&date))), "a date");
  EXPECT_EQ(describe(toGiven(XmlRpc::XmlRpcValue(static_cast<void*>(bytes), 2))), "binary data");
  EXPECT_EQ(describe(toGiven(XmlRpc::XmlRpcValue())), "nothing");
}

TEST(ParametersOfTheCommandNode, haveSoftwareLimitsOfSomeJoints) {
  const auto limited = [](GivenList texts) {
    return readCommandParameters(
        ofNode({{"robot_model", {"tm5-900"}}, {"software_limits", {std::move(texts)}}}));
  };
  const auto parameters = limited({{"1=-90,90"}, {"3=-100.5,100"}});
  ASSERT_TRUE(parameters) << parameters.error().message;
  ASSERT_TRUE(parameters->limits);
  EXPECT_DOUBLE_EQ(parameters->limits->lower[0], degToRad(-90));
  EXPECT_DOUBLE_EQ(parameters->limits->lower[2], degToRad(-100.5));
  EXPECT_EQ(parameters->limits->upper[1], parameters->arm->limits()[1].upper);
  EXPECT_FALSE(limited({})->limits);
  for (const char* text : {"", "1", "0=1,2", "7=1,2", "1=1", "1=1,2,3", "1=a,2", "x=1,2", "1=1, 2"}) {
    const auto refused = limited({{text}});
    ASSERT_FALSE(refused) << text;
    EXPECT_THAT(refused.error().message, HasSubstr("software_limits holds")) << text;
  }
  for (const char* text : {"1=90,-90", "1=-271,0", "1=0,0"}) {
    const auto refused = limited({{text}});
    ASSERT_FALSE(refused) << text;
    EXPECT_THAT(refused.error().message, HasSubstr("the limits of J1 are")) << text;
  }
  const auto twice = limited({{"1=-90,90"}, {"1=-45,45"}});
  ASSERT_FALSE(twice);
  EXPECT_THAT(twice.error().message, HasSubstr("names joint 1 twice"));
  EXPECT_FALSE(readCommandParameters(ofNode({{"software_limits", {GivenList{{"1=-90,90"}}}}})));
}

TEST(ParametersOfTheCommandNode, areTheTableOfThePage) {
  CommandParameters parameters;
  const std::string table = test_support::tableOf(settingsTable(parameters), false);
  EXPECT_NE(test_support::pageAt("doc/parameters.md").find("\n\n" + table + '\n'), std::string::npos)
      << "doc/parameters.md has to have this table:\n"
      << table;
}

TEST(ParametersOfTheSupervisor, areTheTableOfThePage) {
  SupervisorParameters parameters;
  const std::string table = test_support::tableOf(settingsTable(parameters), false);
  EXPECT_NE(test_support::pageAt("doc/cell.md").find("\n\n" + table + '\n'), std::string::npos)
      << "doc/cell.md has to have this table:\n"
      << table;
}

TEST(ParametersOfAMechanism, areTheTableOfThePage) {
  MechanismParameters parameters;
  const std::string table = test_support::tableOf(settingsTable(parameters), false);
  EXPECT_NE(test_support::pageAt("doc/cell.md").find("\n\n" + table + '\n'), std::string::npos)
      << "doc/cell.md has to have this table:\n"
      << table;
}

TEST(ParametersOfTheSupervisor, haveToNameArtifactAndJournal) {
  const auto refusal = [](const GivenValues& values) {
    const auto parameters = readSupervisorParameters(ofNode(values));
    return parameters ? "" : parameters.error().message;
  };
  EXPECT_THAT(refusal({}), HasSubstr("parameter /robot/node/artifact is empty; allowed: an absolute path"));
  EXPECT_THAT(refusal({{"artifact", {"/a"}}}), HasSubstr("/robot/node/journal is empty"));
  EXPECT_THAT(refusal({{"artifact", {"a"}}, {"journal", {"/j"}}}), HasSubstr("an absolute path"));
  EXPECT_THAT(refusal({{"artifact", {"/a"}}, {"journal", {"/j"}}, {"policy", {"mutex"}}}),
              HasSubstr("artifact, supervisor, safe_order or schedule"));
  EXPECT_EQ(refusal({{"artifact", {"/a"}}, {"journal", {"/j"}}, {"policy", {"safe_order"}}}), "");
}

}  // namespace
}  // namespace cobot_command::ros_adapter
