// The journal of a supervisor on a disk that is there, full, torn, damaged, or somebody else's.
#include "cell/journal_file.h"

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <unistd.h>

namespace cobot_command::runtime {
namespace {

using cell::journal::CarriedOut;
using cell::journal::Snapshot;
using cell::journal::Started;
using cell::journal::toLine;
using testing::HasSubstr;

/// No file of this process gets longer than so many bytes while it lives.
class FullDisk {
 public:
  explicit FullDisk(std::size_t bytes) {
    (void)std::signal(SIGXFSZ, SIG_IGN);
    (void)getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit full{static_cast<rlim_t>(bytes), before_.rlim_max};
    (void)setrlimit(RLIMIT_FSIZE, &full);
  }
  ~FullDisk() { (void)setrlimit(RLIMIT_FSIZE, &before_); }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
};

/// A folder of its own, which goes with it.
class JournalFileTest : public testing::Test {
 protected:
  JournalFileTest() {
    char name[] = "/tmp/journal_file_test_XXXXXX";
    if (mkdtemp(name) == nullptr) throw std::runtime_error("no folder for the test");
    folder_ = name;
  }
  ~JournalFileTest() override {
    for (const char* end : {"", ".before", ".new"}) (void)unlink((name() + end).c_str());
    (void)rmdir(folder_.c_str());
  }

  [[nodiscard]] std::string name() const { return folder_ + "/journal"; }
  [[nodiscard]] std::unique_ptr<JournalFile> opened() const {
    auto journal = JournalFile::open(name());
    if (!journal) throw std::runtime_error(journal.error());
    return std::move(*journal);
  }
  [[nodiscard]] std::string refusal() const {
    const auto journal = JournalFile::open(name());
    return journal ? "" : journal.error();
  }
  void write(const std::string& bytes) const { std::ofstream(name(), std::ios::binary) << bytes; }
  /// Of the journal, or of what is beside it.
  [[nodiscard]] std::string bytes(const char* end = "") const {
    std::stringstream text;
    text << std::ifstream(name() + end, std::ios::binary).rdbuf();
    return text.str();
  }

  const std::string first = toLine(Started{7, 1, "0123"});
  const std::string second = toLine(CarriedOut{"RA", 5, {1, cell::NumberedEvent::Kind::Wanted, 3}});
  const std::string third =
      toLine(Snapshot{7,
                      1,
                      "0123",
                      {{"RA", 5, 1, {{1, cell::NumberedEvent::Kind::Wanted, 3}}, false, 1}},
                      {1, 2},
                      "by people",
                      true,
                      9});

 private:
  std::string folder_;
};

TEST_F(JournalFileTest, isMadeWhereThereIsNoneAndReadWhenItIsOpenedAgain) {
  {
    const auto journal = opened();
    EXPECT_TRUE(journal->takeRecords().empty());
    EXPECT_TRUE(journal->append(first));
    EXPECT_TRUE(journal->append(second));
    EXPECT_EQ(bytes(), first + second) << "it is there before anyone is told";
  }
  const auto again = opened();
  const auto records = again->takeRecords();
  ASSERT_EQ(records.size(), 2U);
  EXPECT_EQ(std::get<CarriedOut>(records[1]).event.event, 3U);
  EXPECT_TRUE(again->append(second));
  EXPECT_EQ(bytes(), first + second + second);
}

TEST_F(JournalFileTest, dropsARecordThatWasNotWrittenWholly) {
  for (std::size_t length = 1; length < second.size(); ++length) {
    write(first + second.substr(0, length));
    const auto journal = opened();
    EXPECT_EQ(journal->takeRecords().size(), 1U) << length;
    EXPECT_EQ(bytes(), first) << length;
    EXPECT_TRUE(journal->append(second));
    EXPECT_EQ(bytes(), first + second) << length;
  }
}

TEST_F(JournalFileTest, isRefusedWhereItIsDamagedWithTheLineAndLeftAsItIs) {
  std::string damaged = first + second + second;
  damaged[first.size() + 3] = static_cast<char>(damaged[first.size() + 3] ^ 1);
  write(damaged);
  EXPECT_THAT(refusal(), HasSubstr("damaged at line 2"));
  EXPECT_EQ(bytes(), damaged);
}

TEST_F(JournalFileTest, isOfOneSupervisorAtATime) {
  auto journal = opened();
  EXPECT_THAT(refusal(), HasSubstr("is in use by another supervisor"));
  EXPECT_TRUE(journal->append(first)) << "who has it has it still";
  journal.reset();
  EXPECT_EQ(refusal(), "");
}

TEST_F(JournalFileTest, saysWhyItCannotBeOpened) {
  const auto journal = JournalFile::open(name() + "/in/no/folder");
  ASSERT_FALSE(journal);
  EXPECT_THAT(journal.error(), HasSubstr("cannot be opened: No such file or directory"));
}

TEST_F(JournalFileTest, writesNothingMoreOnceTheDiskWasFull) {
  const auto journal = opened();
  EXPECT_TRUE(journal->append(first));
  {
    const FullDisk disk(first.size() + 10);
    EXPECT_FALSE(journal->append(second));
  }
  EXPECT_FALSE(journal->append(second)) << "behind half a record nothing can be read";
  EXPECT_EQ(bytes(), first + second.substr(0, 10));
}

TEST_F(JournalFileTest, isMendedWhenItIsOpenedBehindAFullDisk) {
  {
    const auto journal = opened();
    EXPECT_TRUE(journal->append(first));
    const FullDisk disk(first.size() + 10);
    EXPECT_FALSE(journal->append(second));
  }
  const auto journal = opened();
  EXPECT_EQ(journal->takeRecords().size(), 1U);
  EXPECT_TRUE(journal->append(second));
  EXPECT_EQ(bytes(), first + second);
}

TEST_F(JournalFileTest, isMadeAnewAndTheOneBeforeIsKeptBesideIt) {
  auto journal = opened();
  EXPECT_TRUE(journal->append(first));
  EXPECT_TRUE(journal->append(second));
  EXPECT_TRUE(journal->replace(third));
  EXPECT_EQ(bytes(), third);
  EXPECT_EQ(bytes(".before"), first + second);
  EXPECT_TRUE(journal->append(second));
  EXPECT_EQ(bytes(), third + second) << "it is gone on with";
  EXPECT_TRUE(journal->replace(third));
  EXPECT_EQ(bytes(".before"), third + second) << "of the last time alone";
  journal.reset();
  EXPECT_EQ(opened()->takeRecords().size(), 1U);
}

TEST_F(JournalFileTest, thatWasMadeAnewIsOfOneSupervisorAtATimeToo) {
  const auto journal = opened();
  EXPECT_TRUE(journal->append(first));
  EXPECT_TRUE(journal->replace(third));
  EXPECT_THAT(refusal(), HasSubstr("is in use by another supervisor"));
}

TEST_F(JournalFileTest, thatCannotBeMadeAnewIsGoneOnWith) {
  const auto journal = opened();
  EXPECT_TRUE(journal->append(first));
  {
    const FullDisk disk(first.size());
    EXPECT_FALSE(journal->replace(third));
  }
  EXPECT_EQ(bytes(), first);
  EXPECT_NE(access((name() + ".new").c_str(), F_OK), 0) << "nothing is left of it";
  EXPECT_TRUE(journal->append(second));
  EXPECT_EQ(bytes(), first + second);
}

TEST_F(JournalFileTest, isNotOfWhatWasLeftWhenItWasBeingMadeAnew) {
  write(first);
  std::ofstream(name() + ".new") << third.substr(0, 20);
  EXPECT_EQ(opened()->takeRecords().size(), 1U);
  EXPECT_TRUE(opened()->replace(third));
  EXPECT_EQ(bytes(), third);
}

}  // namespace
}  // namespace cobot_command::runtime
