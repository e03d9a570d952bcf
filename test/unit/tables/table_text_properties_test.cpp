// Whatever stands in the tables: what is written reads the same. Whatever stands in a file: it is read, or
// refused with its place.

#include "table_support.h"
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/project_name.h"
#include "cobot_command/tables/table_text.h"

namespace cobot_command::testing {
namespace {

using namespace tables;

constexpr double kSame = 1e-9;  // [m], and of rotation matrices

/// As people give them: to 0.001 mm or degrees.
rc::Gen<double> thousandths(int largest) {
  return rc::gen::map(rc::gen::inRange(-largest * 1000, largest * 1000 + 1),
                      [](int n) { return n / 1000.0; });
}
/// Near 90 degrees RX and RZ cannot be told apart; there it is one of the two poles.
rc::Gen<double> middleAngles() {
  return rc::gen::oneOf(thousandths(89), rc::gen::element(90.0, -90.0));
}

rc::Gen<arm::Pose> poses() {
  return rc::gen::map(
      rc::gen::tuple(thousandths(100000), thousandths(2000), thousandths(1), thousandths(180), middleAngles(),
                     thousandths(360)),
      [](const auto& six) { return std::apply([](auto... n) { return arm::toPose({n...}); }, six); });
}

rc::Gen<std::string> names() {
  const auto piece =
      rc::gen::oneOf(rc::gen::element<std::string>("\xC3\xBC", "gripper", "\"", ":", ",", "@", "#", "="),
                     rc::gen::map(rc::gen::inRange(' ', '\x7F'), [](char c) { return std::string(1, c); }));
  return rc::gen::map(rc::gen::container<std::vector<std::string>>(piece), [](const auto& pieces) {
    std::string name = "n";
    for (const std::string& one : pieces) name = name.size() < 200 ? one + name : name;
    return name;
  });
}

template <class Entry>
Entry placed(int Entry::*refers_to, int reference) {
  Entry entry;
  const int what = *rc::gen::inRange(0, 3);
  if (what != 0) entry.name = *names();
  if (what != 1) entry.pose = *poses();
  if (entry.pose) entry.*refers_to = reference;
  return entry;
}

Load someLoad() {
  Load load;
  load.mass = *thousandths(2) + 2;
  if (*rc::gen::arbitrary<bool>()) return load;
  for (double& moment : load.inertia) moment = (*thousandths(500) + 500) * 1e-6;
  load.centre = *poses();
  return load;
}

DataTables someTables() {
  Entries entries;
  entries.loads[1] = someLoad();
  entries.frames[1] = placed(&Frame::reference, 0);
  for (std::size_t i = 2; i < kEntryCount; ++i) {
    if (*rc::gen::arbitrary<bool>()) entries.tools[i] = placed(&Tool::load, *rc::gen::inRange(0, 2));
    if (*rc::gen::arbitrary<bool>()) entries.frames[i] = placed(&Frame::reference, *rc::gen::inRange(0, 2));
    if (*rc::gen::arbitrary<bool>()) entries.loads[i] = someLoad();
  }
  const auto tables = DataTables::of(entries, kPayload);
  RC_ASSERT(tables.has_value());
  return *tables;
}

bool isNear(const std::optional<arm::Pose>& a, const std::optional<arm::Pose>& b) {
  return a.has_value() == b.has_value() && (!a || (a->matrix() - b->matrix()).cwiseAbs().maxCoeff() < kSame);
}
bool isNear(const std::optional<Tool>& a, const std::optional<Tool>& b) {
  return a.has_value() == b.has_value() &&
         (!a || (a->name == b->name && a->load == b->load && isNear(a->pose, b->pose)));
}
bool isNear(const std::optional<Frame>& a, const std::optional<Frame>& b) {
  return a.has_value() == b.has_value() &&
         (!a || (a->name == b->name && a->reference == b->reference && isNear(a->pose, b->pose)));
}
bool isNear(const std::optional<Load>& a, const std::optional<Load>& b) {
  if (a.has_value() != b.has_value() || !a) return a.has_value() == b.has_value();
  bool same = a->mass == b->mass && isNear(a->centre, b->centre);
  for (std::size_t i = 0; i < 3; ++i) same = same && std::abs(a->inertia[i] - b->inertia[i]) < 1e-15;
  return same;
}

void assertSame(const DataTables& a, const DataTables& b) {
  for (std::size_t i = 0; i < kEntryCount; ++i) {
    RC_ASSERT(isNear(a.entries().tools[i], b.entries().tools[i]));
    RC_ASSERT(isNear(a.entries().frames[i], b.entries().frames[i]));
    RC_ASSERT(isNear(a.entries().loads[i], b.entries().loads[i]));
  }
}

RC_GTEST_PROP(TableTextProperty, filesReadAsTheyWereWrittenAndAreWrittenTheSame, ()) {
  const DataTables tables = someTables();
  const std::string text = toFile(tables);
  const auto read = readFile(text, kPayload);
  if (!read) RC_FAIL(describe(read.error()));
  assertSame(tables, read->tables);
  RC_ASSERT(toFile(read->tables) == text);
}

RC_GTEST_PROP(TableTextProperty, listsReadAsTheyWereWritten, ()) {
  const DataTables tables = someTables();
  const auto read = readLists(toLists(tables), kPayload);
  if (!read) RC_FAIL(describe(read.error()));
  assertSame(tables, *read);
}

RC_GTEST_PROP(TableTextProperty, posesOfAnyRotationReadAsTheyWereWritten, ()) {
  const double ry = *rc::gen::map(rc::gen::arbitrary<int>(), [](int n) { return 90.0 - n * 1e-9; });
  Entries entries;
  entries.tools[1] = Tool{"", arm::toPose({1, 2, 3, *thousandths(180), ry, *thousandths(180)}), 0};
  const auto tables = DataTables::of(entries, kPayload);
  const auto read = readFile(toFile(*tables), kPayload);
  RC_ASSERT(read.has_value());
  assertSame(*tables, read->tables);
}

RC_GTEST_PROP(TableTextProperty, damagedFilesAreReadOrRefusedWithTheirPlace, ()) {
  std::string text = toFile(someTables());
  const int blows = *rc::gen::inRange(1, 4);
  for (int i = 0; i < blows; ++i) {
    text[*rc::gen::inRange<std::size_t>(0, text.size())] = *rc::gen::arbitrary<char>();
  }
  const auto read = readFile(text, kPayload);
  if (read) {
    RC_ASSERT(readFile(toFile(read->tables), kPayload).has_value());
  } else {
    RC_ASSERT(read.error().place.rfind("line ", 0) == 0);
    RC_ASSERT(!read.error().reason.empty());
    RC_ASSERT(isUtf8(describe(read.error())));
  }
}

}  // namespace
}  // namespace cobot_command::testing
