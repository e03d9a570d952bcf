// Runs a harness without a fuzzer: on every file of a corpus and on every prefix of it (`fuzz_X DIRECTORY`),
// on one file
// (`fuzz_X FILE`), or on what comes from stdin (`fuzz_X`).
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

/// Of a long file not every prefix is tried: the time would grow with the square of its size.
constexpr std::size_t kMostPrefixes = 1000;

std::string bytesOf(std::istream& stream) {
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// A copy of exactly this size, so that the sanitizer sees every byte that is read behind it.
void runOn(const std::string& bytes, std::size_t size) {
  const std::vector<std::uint8_t> input(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
  LLVMFuzzerTestOneInput(input.data(), input.size());
}

void runOnPrefixes(const std::string& bytes) {
  const std::size_t stride = 1 + bytes.size() / kMostPrefixes;
  for (std::size_t size = 0; size < bytes.size(); size += stride) runOn(bytes, size);
  runOn(bytes, bytes.size());
}

int replay(const std::filesystem::path& corpus) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(corpus)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const auto& path : files) {
    std::printf("%s\n", path.filename().c_str());
    std::fflush(stdout);  // the last name printed is the one to blame
    std::ifstream file(path, std::ios::binary);
    runOnPrefixes(bytesOf(file));
  }
  return files.empty() ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 2) {
    std::fprintf(stderr, "usage: %s [DIRECTORY | FILE]\n", argv[0]);
    return 2;
  }
  if (argc == 2 && std::filesystem::is_directory(argv[1])) return replay(argv[1]);
  std::ifstream file;
  if (argc == 2) file.open(argv[1], std::ios::binary);
  const std::string bytes = bytesOf(argc == 2 ? file : std::cin);
  runOn(bytes, bytes.size());
  return 0;
}
