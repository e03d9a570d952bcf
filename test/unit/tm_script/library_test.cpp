// The examples of the manual where it has some (I848-E-03 and -04, chapters 2 and 3).
#include "script_session.h"
#include <gmock/gmock.h>

namespace cobot_command::tm_script {
namespace {

using ::testing::HasSubstr;

std::string text(const std::string& expression) {
  return Session({1, 84}).valueOf("string", expression);
}
std::string number(const std::string& expression) {
  return Session({1, 84}).valueOf("int", expression);
}
std::string real(const std::string& expression) {
  return Session({1, 84}).valueOf("double", expression);
}
std::string array(const std::string& type, const std::string& expression) {
  return Session({1, 84}).valueOf(type + "[]", expression);
}

/// Six numbers, each as near as the manual prints them.
void expectPose(const std::string& expression, const std::vector<double>& expected, double tolerance = 2e-3) {
  Session session({1, 84});
  ASSERT_EQ(session.run("float[] v = " + expression), "OK") << session.errorOf("float[] v = " + expression);
  const auto& items = std::get<Array>(*session.locals.find("v")).items;
  ASSERT_EQ(items.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(std::get<float>(items[i]), expected[i], tolerance) << expression << ", number " << i;
  }
}

TEST(ByteFunctions, makeNumbersOfBytes) {
  EXPECT_EQ(number("Byte_ToInt16({0x90, 0x01, 0x05}, 0, 0)"), "400");
  EXPECT_EQ(number("Byte_ToInt16({0x90, 0x01, 0x05}, 1, 0)"), "-28671");
  EXPECT_EQ(number("Byte_ToInt16({0x90, 0x01, 0x05}, 1, 1)"), "36865");
  EXPECT_EQ(number("Byte_ToInt32({0xFF, 0xFF, 0xFF, 0xFF})"), "-1");
  EXPECT_EQ(number("Byte_ToInt32({1, 2}, 0)"), "513");  // bytes that are missing are 0
  EXPECT_EQ(number("Byte_ToInt32({1, 2}, 1)"), "16908288");
  EXPECT_EQ(real("Byte_ToFloat({0, 0, 0x80, 0x3F})"), "1");
  EXPECT_EQ(real("Byte_ToDouble({0x3F, 0xF8, 0, 0, 0, 0, 0, 0}, 1)"), "1.5");
  EXPECT_EQ(array("int", "Byte_ToInt16Array({1, 0, 0xFF, 0xFF, 2}, 0, 1)"), "{1,65535,2}");
  EXPECT_EQ(array("int", "Byte_ToInt32Array({1, 0, 0, 0, 2})"), "{1,2}");
  EXPECT_EQ(array("float", "Byte_ToFloatArray(GetBytes({1.5, 2.5}))"), "{1.5,2.5}");
  EXPECT_EQ(array("double", "Byte_ToDoubleArray({})"), "{}");
}

TEST(ByteFunctions, makeTextsOfBytesAndJoinThem) {
  EXPECT_EQ(text("Byte_ToString({0x54, 0x4D, 0, 0x35})"), "TM");  // a 0 ends the text
  EXPECT_EQ(text("Byte_ToString({0x54, 0x4D, 0xAB}, 1)"), "544DAB");
  EXPECT_EQ(text("Byte_ToString({0x54, 0xC3}, 2)"), "T?");
  EXPECT_EQ(array("byte", "Byte_Concat({1, 2}, 3)"), "{1,2,3}");
  EXPECT_EQ(array("byte", "Byte_Concat({1}, {2, 3, 4}, 2)"), "{1,2,3}");
  EXPECT_EQ(array("byte", "Byte_Concat({1}, {2, 3, 4}, -1)"), "{1,2,3,4}");
}

TEST(StringFunctions, makeNumbersAndBytesOfTexts) {
  EXPECT_EQ(number("String_ToInteger(\"1234\")"), "1234");
  EXPECT_EQ(number("String_ToInteger(\"1234\", 16)"), "4660");
  EXPECT_EQ(number("String_ToInteger(\"0x1234\")"), "4660");
  EXPECT_EQ(number("String_ToInteger(\"1100\", 2)"), "12");
  EXPECT_EQ(number("String_ToInteger(\" -7 \")"), "-7");
  EXPECT_EQ(number("String_ToInteger(\"XYZ\")"), "0");
  EXPECT_EQ(real("String_ToDouble(\"-1.25e2\")"), "-125");
  EXPECT_EQ(real("String_ToFloat(\"1,5\")"), "0");
  EXPECT_EQ(array("byte", "String_ToByte(\"TM\")"), "{84,77}");
  EXPECT_EQ(array("byte", "String_ToByte(\"544dAB\", 1)"), "{84,77,171}");
  EXPECT_EQ(array("byte", "String_ToByte(\"T\xC3\xA4M\", 2)"), "{84,63,77}");
  EXPECT_THAT(array("byte", "String_ToByte(\"54x\", 1)"), HasSubstr("no pair of hexadecimal digits"));
}

TEST(StringFunctions, searchAndCutTexts) {
  EXPECT_EQ(text("String_Substring(\"0x12345\", 2, 4)"), "1234");
  EXPECT_EQ(text("String_Substring(\"0x12345\", 2, -1)"), "12345");
  EXPECT_EQ(text("String_Substring(\"0x12345\", 2)"), "12345");
  EXPECT_EQ(text("String_Substring(\"0x12345\", 9, 1)"), "");
  EXPECT_EQ(text("String_Substring(\"0x12345\", \"1\", 4)"), "1234");
  EXPECT_EQ(text("String_Substring(\"0x12345\", \"7\", 4)"), "");
  EXPECT_EQ(text("String_Substring(\"0x12345\", \"1\", \"4\", 1)"), "1234");
  EXPECT_EQ(text("String_Substring(\"0x123450x12-345\", \"1\", \"4\", 2)"), "12-34");
  EXPECT_EQ(text("String_Substring(\"0x12345\", \"1\", \"4\", 2)"), "");
  EXPECT_EQ(number("String_IndexOf(\"012314\", \"1\")"), "1");
  EXPECT_EQ(number("String_LastIndexOf(\"012314\", \"1\")"), "4");
  EXPECT_EQ(number("String_IndexOf(\"012314\", \"9\")"), "-1");
}

TEST(StringFunctions, countCharactersNotBytes) {
  EXPECT_EQ(number("Length(\"\xC3\xA4\xC3\xB6\")"), "2");
  EXPECT_EQ(number("String_IndexOf(\"\xC3\xA4x\", \"x\")"), "1");
  EXPECT_EQ(text("String_Substring(\"\xC3\xA4\xC3\xB6x\", 1, 1)"), "\xC3\xB6");
}

TEST(StringFunctions, splitReplaceTrimAndChangeCase) {
  EXPECT_EQ(array("string", "String_Split(\"a,,b,\", \",\")"), "{a,,b,}");
  EXPECT_EQ(array("string", "String_Split(\"a,,b,\", \",\", 1)"), "{a,b}");
  EXPECT_EQ(array("string", "String_Split(\"a,\"\"b,c\"\",\", \",\", 2)"), "{a,\"b,c\",}");
  EXPECT_EQ(number("Length(String_Split(\"a,\"\"b,c\"\",\", \",\", 3))"), "2");
  EXPECT_EQ(number("Length(String_Split(\"abc\", \"\"))"), "1");
  EXPECT_EQ(text("String_Replace(\"0x0\", \"0\", \"00\")"), "00x00");
  EXPECT_EQ(text("String_Replace(\"abc\", \"\", \"x\")"), "abc");
  EXPECT_EQ(text("String_Trim(\" a b \")"), "a b");
  EXPECT_EQ(text("String_Trim(\"xxabyy\", \"x\", \"y\")"), "ab");
  EXPECT_EQ(text("String_Trim(\"xxabyy\", \"x\")"), "abyy");
  EXPECT_EQ(text("String_ToLower(\"aBC\xC3\x84\")"), "abc\xC3\x84");
  EXPECT_EQ(text("String_ToUpper(\"aBc\")"), "ABC");
}

TEST(ArrayFunctions, giveChangedCopies) {
  Session session;
  EXPECT_EQ(session.run("int[] a = {3,1,2}\r\nint[] b = Array_Append(a, 4)\r\nb = Array_Append(b, {5,6})"),
            "OK");
  EXPECT_EQ(session.variable("a"), "int[] {3,1,2}");
  EXPECT_EQ(session.variable("b"), "int[] {3,1,2,4,5,6}");
  EXPECT_EQ(array("int", "Array_Insert({1,2}, 1, 9)"), "{1,9,2}");
  EXPECT_EQ(array("int", "Array_Insert({1,2}, 2, {8,9})"), "{1,2,8,9}");
  EXPECT_THAT(array("int", "Array_Insert({1,2}, 3, 9)"), HasSubstr("outside of an array of 2"));
  EXPECT_EQ(array("int", "Array_Remove({1,2,3}, 1)"), "{1,3}");
  EXPECT_EQ(array("int", "Array_Remove({1,2,3}, 1, 9)"), "{1}");
  EXPECT_EQ(array("string", "Array_Reverse({\"a\",\"b\"})"), "{b,a}");
  EXPECT_EQ(array("int", "Array_Sort({3,1,2})"), "{1,2,3}");
  EXPECT_EQ(array("float", "Array_Sort({3,1.5,2}, 1)"), "{3,2,1.5}");
  EXPECT_EQ(array("int", "Array_SubElements({1,2,3}, 1, 2)"), "{2,3}");
  EXPECT_EQ(array("int", "Array_SubElements({1,2,3}, 1)"), "{2,3}");
  EXPECT_EQ(array("int", "Array_SubElements({1,2,3}, 4)"), "{}");
}

TEST(ArrayFunctions, searchAndCompareInTheTypeOfTheArray) {
  EXPECT_EQ(Session().valueOf("bool", "Array_Equals({1.0,2.0}, {1,2})"), "True");
  EXPECT_EQ(Session().valueOf("bool", "Array_Equals({1,2}, {1,3})"), "False");
  EXPECT_EQ(number("Array_IndexOf({1.5,2.0,2.0}, 2)"), "1");
  EXPECT_EQ(number("Array_LastIndexOf({1.5,2.0,2.0}, 2)"), "2");
  EXPECT_EQ(number("Array_IndexOf({\"a\"}, \"b\")"), "-1");
}

TEST(ValueFunctions, showBytesOfValues) {
  EXPECT_EQ(array("byte", "GetBytes(1000)"), "{232,3,0,0}");
  EXPECT_EQ(array("byte", "GetBytes(1000, 1)"), "{0,0,3,232}");
  EXPECT_EQ(array("byte", "GetBytes(100)"), "{100}");
  EXPECT_EQ(array("byte", "GetBytes({1000, 1}, 1)"), "{0,0,3,232,0,0,0,1}");
  EXPECT_EQ(array("byte", "GetBytes(\"AB\", 1)"), "{65,66}");
  EXPECT_EQ(number("ValueReverse(0x12345678)"), "2018915346");
  EXPECT_EQ(text("ValueReverse(\"a\xC3\xA4z\")"),
            "z\xC3\xA4"
            "a");
  EXPECT_EQ(array("int", "ValueReverse({1, 256})"), "{16777216,65536}");
}

TEST(ValueFunctions, writeValuesAsTexts) {
  EXPECT_EQ(text("GetString(123)"), "123");
  EXPECT_EQ(text("GetString(12.5)"), "12.5");
  EXPECT_EQ(text("GetString(417.123456, 10, 3)"), "417.123");
  EXPECT_EQ(text("GetString({1.5, 2}, 10, 2)"), "{1.50,2.00}");
  EXPECT_EQ(text("GetString(123, 16)"), "0x7B");
  EXPECT_EQ(text("GetString(5, 2)"), "0b101");
  EXPECT_EQ(text("GetString(-1, 16)"), "0xFFFFFFFF");
  EXPECT_EQ(text("GetString(true)"), "True");
  EXPECT_EQ(text("GetString(1e10)"), "1E+10");
  EXPECT_EQ(text("GetString(0.00001)"), "1E-05");
  EXPECT_EQ(text("GetString(0.1 + 0.2)"), "0.3");
}

TEST(ValueFunctions, findTokens) {
  EXPECT_EQ(text("GetToken(\"$abcd$1234$ABCD$\", \"$\", \"$\")"), "$abcd$");
  EXPECT_EQ(text("GetToken(\"$abcd$1234$ABCD$\", \"$\", \"$\", 2)"), "$ABCD$");
  EXPECT_EQ(text("GetToken(\"$abcd$1234$ABCD$\", \"$\", \"$\", 1, 1)"), "abcd");
  EXPECT_EQ(text("GetToken(\"$abcd\", \"$\", \"$\")"), "");
  EXPECT_EQ(text("GetToken(\"a=1;\", \"a=\", \"\", 1, 1)"), "1;");
  EXPECT_EQ(array("string", "GetAllTokens(\"$abcd$1234$ABCD$\", \"$\", \"$\")"), "{$abcd$,$ABCD$}");
  EXPECT_EQ(array("string", "GetAllTokens(\"(a)(b)\", \"(\", \")\", 1)"), "{a,b}");
  EXPECT_EQ(array("string", "GetAllTokens(\"ab\", \"\", \"\")"), "{ab}");
}

TEST(ValueFunctions, measureValuesAndMakeControlCharacters) {
  EXPECT_EQ(number("Length({1,2,3})"), "3");
  EXPECT_EQ(number("Length(1000)"), "4");
  EXPECT_EQ(number("Length(1.5)"), "4");
  EXPECT_EQ(text("Ctrl(\"a\\r\\n\")"), "a\r\n");
  EXPECT_EQ(text("Ctrl(0x0D0A)"), "\r\n");
  EXPECT_EQ(text("Ctrl({0x0D, 0x0A})"), "\r\n");
  EXPECT_EQ(number("Length(Ctrl(\"\\0\"))"), "1");
}

TEST(ChecksumFunctions, areThoseOfTheWire) {
  EXPECT_EQ(number("XOR8({1,2,4})"), "7");
  EXPECT_EQ(number("SUM8({255,2})"), "1");
  EXPECT_EQ(number("SUM16({255,2})"), "257");
  EXPECT_EQ(number("SUM32({255,255,255})"), "765");
  EXPECT_EQ(number("CRC16(String_ToByte(\"123456789\"))"), "19255");       // 0x4B37, CRC-16/MODBUS
  EXPECT_EQ(number("CRC32(String_ToByte(\"123456789\"))"), "-873187034");  // 0xCBF43926
}

TEST(ChecksumFunctions, makeTheFramesOfTheManual) {
  EXPECT_EQ(text("ListenPacket(\"TMSCT\", \"1,var_i++\")"), "$TMSCT,9,1,var_i++,*06\r\n");
  EXPECT_EQ(text("ListenPacket(\"\", \"2,Techman Robot\")"), "$TMSCT,15,2,Techman Robot,*57\r\n");
  EXPECT_EQ(text("ListenPacket(\"TMSTA\", \"00\")"), "$TMSTA,2,00,*41\r\n");
  EXPECT_EQ(text("ListenPacket(\"1,var_counter++\")"), "$TMSCT,15,1,var_counter++,*26\r\n");
}

TEST(Mathematics, givesTheTypesOfTheManual) {
  EXPECT_EQ(number("abs(-5)"), "5");
  EXPECT_EQ(real("abs(-1.5)"), "1.5");
  EXPECT_EQ(number("pow(2, 10)"), "1024");
  EXPECT_EQ(real("pow(1.5, 2)"), "2.25");
  EXPECT_EQ(real("sqrt(6.25)"), "2.5");
  EXPECT_EQ(number("ceil(100.1)"), "101");
  EXPECT_EQ(number("floor(-0.5)"), "-1");
  EXPECT_EQ(number("round(2.5)"), "3");
  EXPECT_EQ(real("d2r(180)"), "3.14159265358979");
  EXPECT_EQ(real("r2d(atan2(1, 0))"), "90");
  EXPECT_EQ(real("cos(0) + sin(0) + tan(0) + log(1)"), "1");
  EXPECT_EQ(real("r2d(asin(1)) + r2d(acos(1)) + r2d(atan(0))"), "90");
  EXPECT_EQ(real("log10(1000)"), "3");
  EXPECT_EQ(real("sqrt(0 - 1)"), "NaN");
  EXPECT_THAT(number("pow(10, 10)"), HasSubstr("no number that an int holds"));
}

// The numbers are those of the manual; how they are to be computed was found by comparing (tm-robot.md 2.3).
constexpr const char* kFrom = "{-388.3831,-199.8061,367.0702,177.4319,1.717448,-46.02005}";
constexpr const char* kTo = "{-436.9584,115.7343,371.4378,179.4419,-42.86601,-96.91867}";
constexpr const char* kStep = "{-48.57532,315.5404,4.367615,-34.39363,-30.39285,-40.52448}";

TEST(PoseFunctions, giveThePosesOfTheManual) {
  expectPose(std::string("trans(") + kFrom + ", " + kTo + ")",
             {-48.57532, 315.5404, 4.367615, -34.39363, -30.39285, -40.52448});
  expectPose(std::string("inversetrans(") + kStep + ")",
             {206.4934, -100.5999, -221.7758, 44.54835, -2.848977, 48.96799});
  expectPose(
      "changeref({-431.927,-140.6103,368.7306,-179.288,-0.6893783,-105.8449},"
      "{-431.93,-140.61,368.73,-57.70,-44.98,33.62})",
      {0.0020, 0.0000, -0.0023, 113.9423, 14.9346, -123.1989});
}

TEST(PoseFunctions, undoEachOther) {
  expectPose(std::string("applytrans(") + kFrom + ", trans(" + kFrom + ", " + kTo + "))",
             {-436.9584, 115.7343, 371.4378, 179.4419, -42.86601, -96.91867});
  expectPose(std::string("inversetrans(inversetrans(") + kStep + "))",
             {-48.57532, 315.5404, 4.367615, -34.39363, -30.39285, -40.52448});
  const std::string own = std::string("changeref(") + kTo + ", " + kFrom + ")";
  expectPose("changeref(" + own + ", " + kFrom + ", {0,0,0,0,0,0})",
             {-436.9584, 115.7343, 371.4378, 179.4419, -42.86601, -96.91867});
}

TEST(PoseFunctions, goBetweenPoses) {
  expectPose("interpoint({0,0,0,0,0,0}, {100,200,-50,0,0,90}, 0.5)", {50, 100, -25, 0, 0, 45});
  expectPose("interpoint({0,0,0,0,0,170}, {0,0,0,0,0,-170}, 0.25)", {0, 0, 0, 0, 0, 175});
  EXPECT_EQ(real("dist({100,200,100,30,50,20}, {100,100,100,50,50,10})"), "100");
  EXPECT_EQ(real("norm2({3,4,12})"), "13");
  expectPose("trans({0,0,0,0,90,0}, {0,0,0,0,90,0})", {0, 0, 0, 0, 0, 0});
}

TEST(PoseFunctions, makeABaseOfThreePoints) {
  expectPose("points2coord({10,20,30,0,0,0}, {10,70,30,0,0,0}, {0,25,30,0,0,0})", {10, 20, 30, 0, 0, 90});
  EXPECT_THAT(
      Session({1, 84}).errorOf("float[] f = points2coord({0,0,0,0,0,0}, {1,0,0,0,0,0}, {2,0,0,0,0,0})"),
      HasSubstr("three points on one line"));
}

}  // namespace
}  // namespace cobot_command::tm_script
