// The table of the settings: each can be set, what is wrong is refused by name, and it all fits together.
#include "cobot_command/simulator/settings.h"

#include <limits>

#include "settings_text.h"
#include <gmock/gmock.h>

#include "cobot_command/arm/controller_pose.h"

namespace cobot_command::simulator::test {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

GivenList texts(const std::vector<std::string>& all) {
  GivenList list;
  for (const std::string& text : all) list.push_back({text});
  return list;
}

/// "setting found" of the first fault; "" when there is none.
std::string faultOf(const GivenValues& values, const std::string& model = "tm5-900") {
  Settings settings;
  auto fault = take(settingsTable(settings), values);
  if (!fault) fault = faultIn(settings, arm::ArmModel::named(model).value());
  return fault ? fault->setting + ' ' + describe(*fault) : "";
}

/// Another value than the default for each.
GivenValues others() {
  return {{"project_running", {false}},
          {"project_name", {"Cell 7"}},
          {"project_speed", {55}},
          {"project_speed_live", {true}},
          {"start_posture_deg", {GivenList{{10}, {0.5}, {90}, {0}, {90}, {0}}}},
          {"start_tcp", {GivenList{{0}, {0}, {120}, {0}, {0}, {90}}}},
          {"listen_node", {"Listen, left"}},
          {"connection_timeout", {3}},
          {"data_timeout", {4.5}},
          {"reentry_delay", {-1}},
          {"tmflow_version", {1.84}},
          {"bases", {texts({"table=400,0,100,0,0,90", "My base=1,-2.5,3,1e2,0,90"})}},
          {"tcps", {texts({"grip=0,0,150,0,0,0", "HandCamera=0,50,10,0,0,0"})}},
          {"points", {texts({"P1=0,0,90,0,90,0"})}},
          {"variables", {texts({"int g_count = 1", "string name = \"x\""})}},
          {"stop_time", {0.5}},
          {"pvt_lag", {0.05}},
          {"safeguard_resets_itself", {false}},
          {"on_motion_error", {"stop_project"}},
          {"checks_payload", {false}},
          {"accept_zero_ramp", {false}},
          {"safety_limits", {texts({"1=-90,90", "3=-100,100.5"})}},
          {"turn_speed", {90}},
          {"joint_noise", {0.1}},
          {"speed_noise", {0.2}},
          {"torque_noise", {0.3}},
          {"force_noise", {0.4}},
          {"noise_seed", {7}},
          {"velocity_licence", {true}},
          {"accept_empty_length", {true}},
          {"status_period", {0.1}},
          {"stream_format", {"json"}},
          {"stream_items", {"ESTOP, g_count"}},
          {"write_clients", {"10.0.0.7,::1"}},
          {"faults", {texts({"drop_tag 1", "delay_reply 2 0.5", "stale_tag"})}}};
}

TEST(SettingsOfTheSimulator, canAllBeSet) {
  Settings settings;
  const SettingTable table = settingsTable(settings);
  const GivenValues given = others();
  for (const Setting& setting : table) EXPECT_EQ(given.count(setting.name), 1U) << setting.name;
  ASSERT_EQ(given.size(), table.size());
  const auto fault = take(table, given);
  ASSERT_FALSE(fault) << fault->setting << ' ' << describe(*fault);
  // Whoever adds a member has to count it here, and so finds the table.
  const auto& [listen_node, running, posture, start_tcp, period, format, items, clients, speed, speed_live,
               empty_length, faults, on_error, stop_time, pvt_lag, resets, reentry, connection, data, payload,
               zero_ramp, safety_limits, turn_speed, joint_noise, speed_noise, torque_noise, force_noise,
               seed, licence, name, version, bases, tcps, points, variables] = settings;
  EXPECT_EQ(listen_node, "Listen, left");
  EXPECT_FALSE(running);
  EXPECT_TRUE(posture.isApprox(arm::toJointVector({10, 0.5, 90, 0, 90, 0})));
  EXPECT_TRUE(start_tcp.isApprox(arm::toPose({0, 0, 120, 0, 0, 90})));
  EXPECT_EQ(period, 100ms);
  EXPECT_EQ(format, protocol::ItemFormat::Json);
  EXPECT_THAT(items, ElementsAre("ESTOP", "g_count"));
  EXPECT_THAT(clients.value(), ElementsAre("10.0.0.7", "::1"));
  EXPECT_EQ(speed, 55);
  EXPECT_TRUE(speed_live);
  EXPECT_TRUE(empty_length);
  EXPECT_EQ(faults.messages[static_cast<std::size_t>(MessageKind::Tag)].drop.left, 1);
  EXPECT_EQ(faults.messages[static_cast<std::size_t>(MessageKind::Reply)].delay.seconds, 0.5);
  EXPECT_TRUE(faults.stale_tag.on);
  EXPECT_EQ(on_error, MotionErrorPolicy::StopProject);
  EXPECT_EQ(stop_time, 500ms);
  EXPECT_EQ(pvt_lag, 50ms);
  EXPECT_FALSE(resets);
  EXPECT_EQ(reentry, std::nullopt);
  EXPECT_EQ(connection, 3s);
  EXPECT_EQ(data, 4500ms);
  EXPECT_FALSE(payload);
  EXPECT_FALSE(zero_ramp);
  EXPECT_EQ(safety_limits.size(), 2U);
  EXPECT_DOUBLE_EQ(safety_limits.at(0).lower, degToRad(-90));
  EXPECT_DOUBLE_EQ(safety_limits.at(2).upper, degToRad(100.5));
  EXPECT_DOUBLE_EQ(turn_speed, degToRad(90));
  EXPECT_DOUBLE_EQ(joint_noise, degToRad(0.1));
  EXPECT_DOUBLE_EQ(speed_noise, degToRad(0.2));
  EXPECT_EQ(torque_noise, 0.3);
  EXPECT_EQ(force_noise, 0.4);
  EXPECT_EQ(seed, 7);
  EXPECT_TRUE(licence);
  EXPECT_EQ(name, "Cell 7");
  EXPECT_EQ(version, "1.84");
  EXPECT_TRUE(bases.at("table").translation().isApprox(arm::toPose({400, 0, 100, 0, 0, 90}).translation()));
  EXPECT_EQ(bases.size(), 2U);
  EXPECT_EQ(tcps.size(), 2U);
  EXPECT_EQ(points.count("P1"), 1U);
  EXPECT_EQ(variables.size(), 2U);
  EXPECT_EQ(faultOf(given), "");
}

TEST(SettingsOfTheSimulator, fitTogetherWhenLeftAlone) {
  EXPECT_EQ(faultIn(Settings{}), std::nullopt);
  for (const std::string& model : arm::ArmModel::knownNames()) EXPECT_EQ(faultOf({}, model), "") << model;
}

struct Refused {
  GivenValues values;
  std::string words;
};

TEST(SettingsOfTheSimulator, areRefusedByName) {
  const std::vector<Refused> rows{
      {{{"project_name", {""}}}, "project_name is an empty text; allowed: a text of 1 to 128 bytes"},
      {{{"project_name", {std::string(129, 'x')}}}, "project_name is the text \"xxx"},
      {{{"project_name", {"a\nb"}}}, "project_name is the text \"a\\nb\""},
      {{{"listen_node", {""}}},
       "listen_node is an empty text; allowed: a text of 1 to 128 bytes without control"},
      {{{"listen_node", {"Listen\r\n1"}}}, "listen_node is the text \"Listen\\r\\n1\""},
      {{{"project_speed", {7}}}, "project_speed is 7; allowed: a whole number, 5 to 100 in steps of 5 %"},
      {{{"project_speed", {105}}}, "project_speed is 105"},
      {{{"project_speed", {50.0}}}, "project_speed is 50.0"},
      {{{"start_posture_deg", {GivenList{}}}}, "start_posture_deg is a list of 0; allowed: a list of six"},
      {{{"start_posture_deg", {"0,0,90,0,90,0"}}}, "start_posture_deg is the text"},
      {{{"start_posture_deg", {GivenList{{0}, {0}, {90}, {0}, {90}}}}}, "start_posture_deg is a list of 5"},
      {{{"start_posture_deg", {GivenList{{0}, {0}, {90}, {0}, {90}, {kNan}}}}}, "holds nan"},
      {{{"start_posture_deg", {GivenList{{0}, {0}, {90}, {0}, {90}, {true}}}}}, "holds true"},
      {{{"start_posture_deg", {GivenList{{0}, {0}, {170}, {0}, {90}, {0}}}}},
       "start_posture_deg has joint 3 at 170 deg, outside its limits -155 to 155 deg; allowed: postures of "
       "tm5-900"},
      {{{"reentry_delay", {-0.5}}}, "reentry_delay is -0.5; allowed: a number, 0 to 86400 s; or -1: never"},
      {{{"connection_timeout", {-1}}}, "connection_timeout is -1"},
      {{{"data_timeout", {kNan}}}, "data_timeout is nan"},
      {{{"tmflow_version", {"1.79"}}}, "tmflow_version is the text \"1.79\"; allowed: 1.68, 1.72"},
      {{{"tmflow_version", {2}}}, "tmflow_version is 2"},
      {{{"tmflow_version", {kNan}}}, "tmflow_version is the text \"nan\""},
      {{{"bases", {"table=1,2,3,4,5,6"}}}, "bases is the text"},
      {{{"bases", {GivenList{{5}}}}}, "bases holds 5; allowed: a list of texts NAME=X,Y,Z,RX,RY,RZ"},
      {{{"bases", {texts({"table"})}}}, "bases holds \"table\": there is no ="},
      {{{"bases", {texts({"=1,2,3,4,5,6"})}}}, "the text before = is not a name"},
      {{{"bases", {texts({" a=1,2,3,4,5,6"})}}}, "the text before = is not a name"},
      {{{"bases", {texts({"a\"b=1,2,3,4,5,6"})}}}, "the text before = is not a name"},
      {{{"bases", {texts({"a\nb=1,2,3,4,5,6"})}}}, "the text before = is not a name"},
      {{{"bases", {texts({"b=1,2,3,4,5"})}}}, "the text after = is not six numbers"},
      {{{"bases", {texts({"b=1,2,3,4,5,6,7"})}}}, "the text after = is not six numbers"},
      {{{"bases", {texts({"b=1,2,3,4,5,x"})}}}, "the text after = is not six numbers"},
      {{{"bases", {texts({"b=1,2,3,4,5,nan"})}}}, "bases holds"},
      {{{"bases", {texts({"b=1,2,3,4,5,inf"})}}}, "bases holds"},
      {{{"bases", {texts({"b=1e300,2,3,4,5,6"})}}}, "a number is beyond 100000"},
      {{{"bases", {texts({"a=1,2,3,4,5,6", "b=1,2,3,4,5,6", "a=0,0,0,0,0,0"})}}}, "bases names \"a\" twice"},
      {{{"bases", {texts({"RobotBase=1,2,3,4,5,6"})}}}, "bases names RobotBase, which every project has"},
      {{{"tcps", {texts({"NOTOOL=1,2,3,4,5,6"})}}}, "tcps names NOTOOL, which every project has"},
      {{{"tcps", {texts({"a=1,2,3,4,5,6", "a=1,2,3,4,5,6"})}}}, "tcps names \"a\" twice"},
      {{{"points", {texts({"P1=0,0,90,0,90,0", "P1=0,0,0,0,0,0"})}}}, "points names \"P1\" twice"},
      {{{"points", {texts({"P1=0,0,90,0,90,0", "P2=0,0,90,0,90,400"})}}},
       "points \"P2\" has joint 6 at 400 deg, outside its limits -270 to 270 deg"},
      {{{"variables", {"int var_i = 5"}}}, "variables is the text"},
      {{{"variables", {texts({"int PTP"})}}}, "variables holds \"int PTP\": PTP is a function"},
      {{{"variables", {texts({"int GetNow"})}}}, "GetNow is a function"},
      {{{"variables", {texts({"int abs = 1"})}}}, "abs is a function"},
      {{{"variables", {texts({"int true = 1"})}}}, "true is a word of the language"},
      {{{"variables", {texts({"int while = 1"})}}}, "while is a word of the language"},
      {{{"variables", {texts({"int Base"})}}}, "Base is an object with attributes"},
      {{{"variables", {texts({"bool ESTOP = true"})}}}, "ESTOP is a predefined item"},
      {{{"variables", {texts({"int float = 1"})}}}, "variables holds \"int float = 1\""},
      {{{"variables", {texts({"int i", "float i"})}}}, "there is a variable i already"},
      {{{"safety_limits", {texts({"1"})}}},
       "safety_limits holds \"1\"; allowed: a list of texts N=LOWER,UPPER"},
      {{{"safety_limits", {texts({"7=-1,1"})}}}, "safety_limits holds \"7=-1,1\""},
      {{{"safety_limits", {texts({"0=-1,1"})}}}, "safety_limits holds \"0=-1,1\""},
      {{{"safety_limits", {texts({"J=-1,1"})}}}, "safety_limits holds \"J=-1,1\""},
      {{{"safety_limits", {texts({"1=-1"})}}}, "safety_limits holds \"1=-1\""},
      {{{"safety_limits", {texts({"1=1,-1"})}}}, "safety_limits holds \"1=1,-1\""},
      {{{"safety_limits", {texts({"1=nan,1"})}}}, "safety_limits holds \"1=nan,1\""},
      {{{"safety_limits", {texts({"1=-1,1", "1=-2,2"})}}}, "safety_limits names joint 1 twice"},
      {{{"stop_time", {-0.1}}}, "stop_time is -0.1; allowed: a number, 0 to 60 s"},
      {{{"on_motion_error", {"explode"}}},
       "on_motion_error is the text \"explode\"; allowed: report_false or"},
      {{{"safeguard_resets_itself", {"no"}}}, "safeguard_resets_itself is the text \"no\"; allowed: true or"},
      {{{"status_period", {0.0}}}, "status_period is 0.0; allowed: a number, 0.001 to 1 s"},
      {{{"stream_format", {"xml"}}}, "stream_format is the text \"xml\"; allowed: binary, string or json"},
      {{{"stream_format", {""}}}, "stream_format is an empty text"},
      {{{"stream_items", {""}}}, "stream_items names no item"},
      {{{"stream_items", {" , ,"}}}, "stream_items names no item"},
      {{{"stream_items", {"Bogus"}}},
       "stream_items names \"Bogus\", which is neither an item nor one of the"},
      {{{"write_clients", {""}}}, "write_clients names no address; allowed: all, none, or addresses"},
      {{{"write_clients", {"999.1.1.1"}}}, "write_clients names \"999.1.1.1\", which is not an address"},
      {{{"write_clients", {"10.0.0.7,everybody"}}}, "write_clients names \"everybody\""},
      {{{"write_clients", {"10.0.0"}}}, "write_clients names \"10.0.0\""},
      {{{"faults", {texts({"drop_tgs"})}}}, "faults holds \"drop_tgs\": unknown fault"},
      {{{"faults", {texts({"drop_tag -1"})}}}, "faults holds \"drop_tag -1\": drop_tag -1 times"},
      {{{"faults", {texts({"delay_reply 1"})}}}, "faults holds \"delay_reply 1\": \"\": give the delay"},
      {{{"faults", {texts({"delay_reply 1 nan"})}}}, "faults holds"},
      {{{"faults", {texts({""})}}}, "faults holds \"\": unknown fault"},
  };
  for (const Refused& row : rows) {
    const std::string fault = faultOf(row.values);
    EXPECT_EQ(fault.substr(0, fault.find(' ')), row.values.begin()->first) << row.words;
    EXPECT_THAT(fault, HasSubstr(row.words));
  }
}

TEST(SettingsOfTheSimulator, blameWhatIsWrongAndNotWhatIsThere) {
  EXPECT_THAT(faultOf({{"variables", {texts({"int 1x"})}}, {"stream_items", {"ESTOP"}}}),
              HasSubstr("variables holds \"int 1x\""));
  EXPECT_THAT(faultOf({{"variables", {texts({"int x = 1"})}}, {"stream_items", {"y"}}}),
              HasSubstr("stream_items names \"y\""));
}

TEST(SettingsOfTheSimulator, mayReplaceTheCameraOnly) {
  EXPECT_EQ(faultOf({{"tcps", {texts({"HandCamera=0,0,10,0,0,0"})}}}), "");
}

TEST(SettingsText, listsNamesAndClients) {
  EXPECT_THAT(parseNames(" A,Bc , ,D"), ElementsAre("A", "Bc", "D"));
  EXPECT_FALSE(parseWriteClients("all")->has_value());
  EXPECT_TRUE(parseWriteClients("none")->value().empty());
  EXPECT_THAT(parseWriteClients("10.0.0.7, ::1")->value(), ElementsAre("10.0.0.7", "::1"));
  EXPECT_THAT(parseWriteClients("::ffff:10.0.0.7, 0:0::0001")->value(), ElementsAre("10.0.0.7", "::1"));
}

TEST(SettingsText, namesSixNumbers) {
  const auto named = parseNamedNumbers("My base=1,-2.5,3,1e2,0,90");
  EXPECT_EQ(named->first, "My base");
  EXPECT_THAT(named->second, ElementsAre(1, -2.5, 3, 100, 0, 90));
}

}  // namespace
}  // namespace cobot_command::simulator::test
