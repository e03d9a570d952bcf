#include "cobot_command/common/sha256.h"

#include <cstddef>
#include <string>
#include <utility>

#include <gtest/gtest.h>

namespace cobot_command {
namespace {

constexpr const char* kOfNothing = "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855";
constexpr const char* kOfAbc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

/// FIPS 180-2, appendix B, and the vectors of NIST's CAVP.
TEST(Sha256, isThatOfThePublishedVectors) {
  EXPECT_EQ(sha256Hex(""), kOfNothing);
  EXPECT_EQ(sha256Hex("abc"), kOfAbc);
  EXPECT_EQ(sha256Hex("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256Hex(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
  EXPECT_EQ(sha256Hex("\xd3"), "28969cdfa74a12c82f3bad960b0b000aca2ac329deea5c2328ebc6f2ba9802c1");
}

TEST(Sha256, takesBytesOfAnyKind) {
  EXPECT_EQ(sha256Hex(std::string(64, '\0')),
            "f5a5fd42d16a20302798ef6ed309979b43003d2320d9f0e8ea9831a92759fb4b");
}

TEST(Sha256, doesNotDependOnHowTheBytesAreCut) {
  const std::string text(1000, 'x');
  for (const std::size_t piece : {1U, 7U, 63U, 64U, 65U, 999U}) {
    Sha256 hash;
    for (std::size_t i = 0; i < text.size(); i += piece) hash.update(text.substr(i, piece));
    EXPECT_EQ(hash.hex(), sha256Hex(text)) << piece;
  }
}

TEST(Sha256, goesOnBehindADigest) {
  Sha256 hash;
  EXPECT_EQ(hash.hex(), kOfNothing);
  hash.update("ab");
  EXPECT_NE(hash.hex(), kOfAbc);
  hash.update("c");
  EXPECT_EQ(hash.hex(), kOfAbc);
  EXPECT_EQ(hash.hex(), kOfAbc);
}

TEST(Sha256, ofACopyGoesOnByItself) {
  Sha256 hash;
  hash.update("ab");
  Sha256 copy = hash;
  copy.update("c");
  hash.update("d");
  EXPECT_EQ(copy.hex(), kOfAbc);
  EXPECT_EQ(hash.hex(), sha256Hex("abd"));
  hash = std::move(copy);
  EXPECT_EQ(hash.hex(), kOfAbc);
}

}  // namespace
}  // namespace cobot_command
