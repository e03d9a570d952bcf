#include "cobot_command/script/script_command.h"

#include <clocale>
#include <locale>
#include <set>
#include <string>
#include <utility>

#include "test_names.h"
#include <gmock/gmock.h>

#include "cobot_command/script/script_reader.h"

namespace cobot_command::script {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// The only command of the text.
ScriptCommand read(std::string_view text) {
  const auto commands = readScript(text);
  EXPECT_TRUE(commands) << text << ": " << commands.error().front().reason;
  EXPECT_TRUE(!commands || commands->size() == 1) << text;
  return commands && !commands->empty() ? commands->front().command : Pause{};
}

template <class Command>
Command parsed(std::string_view line) {
  const ScriptCommand command = read(line);
  const auto* value = std::get_if<Command>(&command);
  EXPECT_NE(value, nullptr) << line << " is another command";
  return value == nullptr ? Command{} : *value;
}

// The commands of TM 1.7 and of the manual: the text that is read and the one that is written.
struct TextPair {
  const char* read;
  const char* written;
};
void PrintTo(const TextPair& pair, std::ostream* out) {
  *out << pair.read;
}

class KnownText : public ::testing::TestWithParam<TextPair> {};
INSTANTIATE_TEST_SUITE_P(
    ScriptCommand, KnownText,
    ::testing::Values(
        TextPair{"PTP(\"JPP\",0,0,90,0,90,0,35,200,0,false)", "PTP(\"JPP\",0,0,90,0,90,0,35,200,0,false)"},
        TextPair{"PTP(\"CPP\",417.50,-122.30,343.90,180.00,0.00,90.00,10,200,0,false,0,2,4)",
                 "PTP(\"CPP\",417.5,-122.3,343.9,180,0,90,10,200,0,false,0,2,4)"},
        TextPair{"PTP(\"CPP\",{417.50,-122.30,343.90,180.00,0.00,90.00},10,200,0,true,{0,2,4})",
                 "PTP(\"CPP\",417.5,-122.3,343.9,180,0,90,10,200,0,true,0,2,4)"},
        TextPair{"Line(\"CAR\",417.50,-122.30,343.90,180.00,0.00,90.00,100,200,50,false)",
                 "Line(\"CAR\",417.5,-122.3,343.9,180,0,90,100,200,50,false)"},
        TextPair{
            "Circle(\"CAP\",417.50,-122.30,343.90,180.00,0.00,90.00,381.70,208.74,343.90,180.00,0.00,135.00,"
            "100,200,50,270,false)",
            "Circle(\"CAP\",417.5,-122.3,343.9,180,0,90,381.7,208.74,343.9,180,0,135,100,200,50,270,false)"},
        TextPair{"Move_PTP(\"TPP\",0,0,10,45,0,0,10,200,0,false)",
                 "Move_PTP(\"TPP\",0,0,10,45,0,0,10,200,0,false)"},
        TextPair{"Move_Line(\"TAP\",0,0,10,45,0,0,125,200,0,false)",
                 "Move_Line(\"TAP\",0,0,10,45,0,0,125,200,0,false)"},
        TextPair{"PLine(\"JAP\",0,0,90,0,90,0,100,200,50)", "PLine(\"JAP\",0,0,90,0,90,0,100,200,50)"},
        TextPair{"PLine(\"CAP\",{417.50,-122.30,343.90,180.00,0.00,90.00},100,200,50)",
                 "PLine(\"CAP\",417.5,-122.3,343.9,180,0,90,100,200,50)"},
        TextPair{"Move_PLine(\"TAP\",0,0,10,45,0,0,125,200,0)",
                 "Move_PLine(\"TAP\",0,0,10,45,0,0,125,200,0)"},
        TextPair{"PVTEnter()", "PVTEnter(0)"}, TextPair{"PVTEnter(1)", "PVTEnter(1)"},
        TextPair{"PVTPoint(0,0,90,0,90,0,0,0,0,0,0,0,2.0)", "PVTPoint(0,0,90,0,90,0,0,0,0,0,0,0,2)"},
        TextPair{"PVTPoint({0,0,90,0,90,0},{1,2,3,4,5,6},0.025)",
                 "PVTPoint(0,0,90,0,90,0,1,2,3,4,5,6,0.025)"},
        TextPair{"PVTExit()", "PVTExit()"}, TextPair{"PVTPause()", "PVTPause()"},
        TextPair{"PVTResume()", "PVTResume()"}, TextPair{"ContinueVJog()", "ContinueVJog()"},
        TextPair{"ContinueVLine(5000,10000)", "ContinueVLine(5000,10000)"},
        TextPair{"SetContinueVJog(1,0,0,0,0,-0.5)", "SetContinueVJog(1,0,0,0,0,-0.5)"},
        TextPair{"SetContinueVLine(10,0,0,0,0,5)", "SetContinueVLine(10,0,0,0,0,5)"},
        TextPair{"StopContinueVmode()", "StopContinueVmode()"},
        TextPair{"SuspendContinueVmode()", "SuspendContinueVmode()"},
        TextPair{"ChangeBase(20,30,10,0,0,90)", "ChangeBase(20,30,10,0,0,90)"},
        TextPair{"ChangeBase(\"RobotBase\")", "ChangeBase(\"RobotBase\")"},
        TextPair{"ChangeTCP(\"NOTOOL\")", "ChangeTCP(\"NOTOOL\")"},
        TextPair{"ChangeTCP({0,0,150,0,0,90})", "ChangeTCP(0,0,150,0,0,90)"},
        TextPair{"ChangeTCP(0,0,150,0,0,90,2)", "ChangeTCP(0,0,150,0,0,90,2)"},
        TextPair{"ChangeTCP(0,0,150,0,0,90,2,2,0.5,0.5,0,0,-80,0,0,0)",
                 "ChangeTCP(0,0,150,0,0,90,2,2,0.5,0.5,0,0,-80,0,0,0)"},
        TextPair{"ChangeTCP({0,0,150,0,0,90},2,{2,0.5,0.5,0,0,-80,0,0,0})",
                 "ChangeTCP(0,0,150,0,0,90,2,2,0.5,0.5,0,0,-80,0,0,0)"},
        TextPair{"ChangeLoad(5.3)", "ChangeLoad(5.3)"}, TextPair{"QueueTag(1,1)", "QueueTag(1,1)"},
        TextPair{"QueueTag(15)", "QueueTag(15,0)"}, TextPair{"WaitQueueTag(1,5000)", "WaitQueueTag(1,5000)"},
        TextPair{"WaitQueueTag(0,-1)", "WaitQueueTag(0,-1)"}, TextPair{"WaitQueueTag(3)", "WaitQueueTag(3)"},
        TextPair{"StopAndClearBuffer()", "StopAndClearBuffer()"},
        TextPair{"StopAndClearBuffer(2)", "StopAndClearBuffer(2)"}, TextPair{"Pause()", "Pause()"},
        TextPair{"Resume()", "Resume()"}, TextPair{"ScriptExit()", "ScriptExit()"},
        TextPair{"ScriptExit(1)", "ScriptExit(1)"},
        TextPair{"IO[\"ControlBox\"].DO[2]=1", "IO[\"ControlBox\"].DO[2]=1"},
        TextPair{" IO [ \"EndModule\" ] . InstantDO [ 0x3 ] = 0 // open", "IO[\"EndModule\"].InstantDO[3]=0"},
        TextPair{"IO[\"ControlBox\"].DO[15]=0", "IO[\"ControlBox\"].DO[15]=0"}),
    [](const auto& test) { return testName(test.index, test.param.read); });

TEST_P(KnownText, isReadAndWritten) {
  EXPECT_EQ(toText(read(GetParam().read)), GetParam().written);
}

TEST_P(KnownText, isReadAgainAsTheSame) {
  EXPECT_EQ(toText(read(GetParam().written)), GetParam().written);
}

TEST(ReadCommand, putsEveryArgumentInItsPlace) {
  const auto ptp = parsed<Ptp>("PTP(\"CPP\",1,2,3,4,5,6,7,8,9,true,0,2,4)");
  EXPECT_EQ(ptp.format, (DataFormat{DataFormat::Target::Cartesian}));
  EXPECT_THAT(ptp.target, ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_EQ(ptp.options.speed, 7);
  EXPECT_EQ(ptp.options.accel_time, 8);
  EXPECT_EQ(ptp.options.blending, 9);
  EXPECT_TRUE(ptp.options.disable_precise_positioning);
  ASSERT_TRUE(ptp.pose_bits);
  EXPECT_THAT(*ptp.pose_bits, ElementsAre(0, 2, 4));

  const auto circle = parsed<Circle>("Circle(\"CAP\",1,2,3,4,5,6,11,12,13,14,15,16,7,8,9,270,true)");
  EXPECT_EQ(circle.format.speed, DataFormat::Speed::Absolute);
  EXPECT_THAT(circle.via, ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_THAT(circle.end, ElementsAre(11, 12, 13, 14, 15, 16));
  EXPECT_EQ(circle.options.blending, 9);
  EXPECT_EQ(circle.arc_angle, 270);
  EXPECT_TRUE(circle.options.disable_precise_positioning);

  const auto line = parsed<Line>("Line(\"CAR\",1,2,3,4,5,6,7,8,9,false)");
  EXPECT_EQ(line.format.blending, DataFormat::Blending::Radius);
  EXPECT_THAT(line.target, ElementsAre(1, 2, 3, 4, 5, 6));

  const auto tcp = parsed<ChangeTcp>("ChangeTCP(1,2,3,4,5,6,7,11,12,13,14,15,16,17,18,19)");
  EXPECT_THAT(std::get<SixNumbers>(tcp.tcp), ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_EQ(tcp.weight, 7.0);
  ASSERT_TRUE(tcp.inertia);
  EXPECT_THAT(tcp.inertia->moment, ElementsAre(11, 12, 13));
  EXPECT_THAT(tcp.inertia->mass_center, ElementsAre(14, 15, 16, 17, 18, 19));
}

TEST(ReadCommand, readsWhichOutputIsWrittenAndHow) {
  const auto write = parsed<WriteOutput>("IO[\"EndModule\"].DO[3]=1");
  EXPECT_EQ(write.module, IoModule::EndModule);
  EXPECT_EQ(write.index, 3);
  EXPECT_TRUE(write.on);
  EXPECT_FALSE(write.instant);
  EXPECT_TRUE(parsed<WriteOutput>("IO[\"ControlBox\"].InstantDO[0]=0").instant);
}

TEST(ReadCommand, readsTheVoltsOfTheAnalogOutput) {
  const auto write = parsed<WriteAnalogOutput>("IO[\"ControlBox\"].AO[0]=-2.5");
  EXPECT_EQ(write.volt, -2.5);
  EXPECT_FALSE(write.instant);
  EXPECT_TRUE(parsed<WriteAnalogOutput>("IO[\"ControlBox\"].InstantAO[0]=10").instant);
}

TEST(ReadCommand, takesBlanksCommentsAndAllSpellings) {
  const auto wait = parsed<WaitQueueTag>(" \tWaitQueueTag ( 0x0A , 0b101 ) // until it is there");
  EXPECT_EQ(wait.tag, 10);
  EXPECT_EQ(wait.timeout, 5);
  EXPECT_TRUE(
      parsed<Line>("Line(\"CPP\",{1,2.,.3,+4,-5,-.6},1,2,3,True)").options.disable_precise_positioning);
  EXPECT_FALSE(
      parsed<Line>("Line(\"CPP\",{1,2.,.3,+4,-5,-.6},1,2,3,False)").options.disable_precise_positioning);
}

TEST(ReadCommand, readsNumbersExactly) {
  EXPECT_EQ(parsed<ChangeLoad>("ChangeLoad(10.1)").weight, 10.1);
  EXPECT_EQ(parsed<ChangeLoad>("ChangeLoad(417.123456)").weight, 417.123456);
  EXPECT_EQ(parsed<ChangeLoad>("ChangeLoad(-0.04263335)").weight, -0.04263335);
  EXPECT_DOUBLE_EQ(parsed<ChangeLoad>("ChangeLoad(99999999999999999999)").weight, 1e20);
}

TEST(ReadCommand, readsADoubledQuoteAsOne) {
  EXPECT_EQ(std::get<std::string>(parsed<ChangeBase>("ChangeBase(\"a\"\"b//c\")").base), "a\"b//c");
}

template <std::size_t... places>
std::vector<ScriptCommand> oneOfEach(std::index_sequence<places...> /*all*/) {
  return {ScriptCommand(std::in_place_index<places>)...};
}

/// A row that is forgotten, or stands twice, shows here.
TEST(ToText, isToBeHadOfEveryCommandAndTellsThemApart) {
  std::set<std::string> functions;
  const auto all = oneOfEach(std::make_index_sequence<std::variant_size_v<ScriptCommand>>());
  for (ScriptCommand command : all) {
    if (auto* base = std::get_if<ChangeBase>(&command)) base->base = "a";
    const std::string text = toText(command);
    functions.insert(text.substr(0, text.find('(')));
  }
  EXPECT_EQ(functions.size(), all.size());
}

TEST(ToText, joinsLinesWithoutOneAtTheEnd) {
  EXPECT_EQ(toText(std::vector<ScriptCommand>{Pause{}, QueueTag{3, true}, ScriptExit{}}),
            "Pause()\r\nQueueTag(3,1)\r\nScriptExit()");
  EXPECT_EQ(toText(std::vector<ScriptCommand>{}), "");
}

TEST(ToText, writesShortNumbersWithoutExponent) {
  const auto written = [](double value) { return toText(ChangeLoad{value}); };
  EXPECT_EQ(written(0), "ChangeLoad(0)");
  EXPECT_EQ(written(-0.0), "ChangeLoad(0)");
  EXPECT_EQ(written(-1e-9), "ChangeLoad(0)");
  EXPECT_EQ(written(0.1 + 0.2), "ChangeLoad(0.3)");
  EXPECT_EQ(written(100), "ChangeLoad(100)");
  EXPECT_EQ(written(1e-6), "ChangeLoad(0.000001)");
  EXPECT_EQ(written(-417.123456), "ChangeLoad(-417.123456)");
  EXPECT_EQ(written(1e20), "ChangeLoad(100000000000000000000)");
}

TEST(ToText, doublesQuotesInNames) {
  EXPECT_EQ(toText(ChangeBase{"a\"),b"}), "ChangeBase(\"a\"\"),b\")");
  EXPECT_EQ(std::get<std::string>(parsed<ChangeBase>(toText(ChangeBase{"a\"),b"})).base), "a\"),b");
}

TEST(IsName, refusesWhatCouldBreakTheLine) {
  EXPECT_TRUE(isName("RobotBase"));
  EXPECT_TRUE(isName("base \"2\", \u9054\u660e $*"));
  EXPECT_TRUE(isName(std::string(kMaxNameLength, 'x')));
  EXPECT_FALSE(isName(""));
  EXPECT_FALSE(isName(std::string(kMaxNameLength + 1, 'x')));
  EXPECT_FALSE(isName("a\r\nScriptExit()"));
  EXPECT_FALSE(isName(std::string("a\0b", 3)));
  EXPECT_FALSE(isName("\xC8"));
}

TEST(ScriptLine, isUtf8WithoutControlCharactersOtherThanTabs) {
  EXPECT_TRUE(isScriptLine(""));
  EXPECT_TRUE(isScriptLine("\tvar_s = \"\u9054\u660e $*\" // text"));
  EXPECT_TRUE(isScriptLine(std::string(4096, 'x')));
  for (const std::string& bad : {std::string("a\r"), std::string("a\nb"), std::string("a\0b", 3),
                                 std::string("\x7F"), std::string("\xC8")}) {
    EXPECT_FALSE(isScriptLine(bad));
  }
}

#ifdef NDEBUG
TEST(ToText, keepsAForgottenCheckOfANameFromBecomingACommand) {
  EXPECT_EQ(toText(ChangeBase{"a\r\nScriptExit()"}), "ChangeBase(\"aScriptExit()\")");
}
#else
TEST(ToTextDeathTest, assertsThatANameIsOne) {
  EXPECT_DEATH(static_cast<void>(toText(ChangeBase{"a\r\nScriptExit()"})), "isName");
}
#endif

/// Numbers of the C++ and C library with a decimal comma, as in a German locale, for the time of a test.
class DecimalComma : public ::testing::Test {
 protected:
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  DecimalComma() : before_(std::locale::global(std::locale(std::locale::classic(), new Comma))) {
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"}) {
      if (std::setlocale(LC_NUMERIC, name) != nullptr) break;
    }
  }
  ~DecimalComma() override {
    std::setlocale(LC_NUMERIC, "C");
    std::locale::global(before_);
  }
  std::locale before_;
};

TEST_F(DecimalComma, changesNeitherWrittenNorReadNumbers) {
  const std::string text = toText(Line{{}, {1234567.5, 0.25, -3, 0, 0, 0}, {1000, 2000, 0, false}});
  EXPECT_EQ(text, "Line(\"CPP\",1234567.5,0.25,-3,0,0,0,1000,2000,0,false)");
  EXPECT_EQ(parsed<Line>(text).target[0], 1234567.5);
}

}  // namespace
}  // namespace cobot_command::script
