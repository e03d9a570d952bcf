#!/usr/bin/env python3
"""check_sizes.py finds what it is for."""
import pathlib
import tempfile
import unittest

import check_sizes

ALL_KINDS = """
namespace some {
// class Comment { void a(); };
class Other;
enum class Kind { One, Two };
template <class T>
class [[nodiscard]] Counted final : public Base<T>, private Held {
 public:
  using Call = std::function<void(int)>;
  explicit Counted(int a) : a_(a), text_("x{") {}
  Counted(const Counted&) = delete;
  ~Counted() override = default;
  Counted& operator=(const Counted&) = delete;
  friend bool operator==(const Counted& a, const Counted& b) { return a.a_ == b.a_; }
  static_assert(sizeof(int) == 4, "so it is");

  void one();
  [[nodiscard]] int two() const { return a_ == 0 ? helper({1, 2}) : a_; }
  [[nodiscard]] std::optional<std::pair<int, int>> three(const std::function<void(int)>& with = {}) const;
  template <class Other>
  void four(Other&& other) { for (;;) { if (other()) return; } }
  static constexpr bool five() noexcept { return true; }

 private:
  struct Part {
    Part() = default;
    void of_the_part();
    int number = 0;
  };
  virtual void six() = 0;
  auto seven() -> std::vector<int>;

  int a_ = std::max(1, 2);
  std::function<void(int)> told_;
  std::vector<Part> parts_{Part(), Part()};
  const char* text_ = R"(void none();)";
};
void outside();
}
"""


def write(root, name, text):
    file = pathlib.Path(root, name)
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text, encoding="utf-8")
    return file


def faults_of(files):
    with tempfile.TemporaryDirectory() as root:
        for name, text in files.items():
            write(root, name, text)
        return list(check_sizes.faults(pathlib.Path(root)))


def class_with(methods, name="Some"):
    return f"class {name} {{\n" + "".join(f"  void f{i}(int a, int b);\n" for i in range(methods)) + "  int a_ = 0;\n};\n"


class CheckSizes(unittest.TestCase):
    def test_counts_methods_of_all_kinds_and_nothing_else(self):
        with tempfile.TemporaryDirectory() as root:
            file = write(root, "src/link/some.h", ALL_KINDS)
            self.assertEqual(dict(check_sizes.classes_of(file)), {"Counted": 7, "Part": 1})

    def test_finds_a_class_that_is_too_large(self):
        for place in ("src/link/some.h", "src/link/some.cpp", "include/cobot_command/link/wing/some.h"):
            most = check_sizes.MOST_METHODS
            self.assertEqual(faults_of({place: class_with(most)}), [])
            self.assertEqual(faults_of({place: class_with(most + 1)}), [f"{place}: Some has {most + 1} methods, more than {most}"])
        self.assertIn("Core::Impl has", "".join(faults_of({"src/link/impl.h": class_with(50, "Core::Impl")})))

    def test_leaves_the_classes_of_the_tests(self):
        self.assertEqual(faults_of({"test/unit/link/some.cpp": class_with(50)}), [])

    def test_finds_a_folder_that_is_too_full(self):
        files = {f"src/link/some_{i}.cpp": "" for i in range(check_sizes.MOST_FILES)}
        self.assertEqual(faults_of({**files, "src/link/wing/one.cpp": "", "src/link/CMakeLists.txt": ""}), [])
        self.assertIn("src/link/ has", "".join(faults_of({**files, "src/link/one_more.h": ""})))


if __name__ == "__main__":
    unittest.main()
