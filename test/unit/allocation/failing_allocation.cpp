#include "failing_allocation.h"

namespace cobot_command::allocation {
namespace {

// Plain numbers: they are there before the first constructor runs. One thread.
bool counts = false;
bool has_failed = false;
long until_failure = 0;
long live = 0;

void* allocate(std::size_t size) {
  if (counts && until_failure > 0 && --until_failure == 0) {
    has_failed = true;
    throw std::bad_alloc();
  }
  void* const memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) {
    throw std::bad_alloc();
  }
  ++live;
  return memory;
}

void* allocateAligned(std::size_t size, std::align_val_t alignment) {
  if (counts && until_failure > 0 && --until_failure == 0) {
    has_failed = true;
    throw std::bad_alloc();
  }
  const auto boundary = static_cast<std::size_t>(alignment);
  void* const memory = std::aligned_alloc(boundary, (size + boundary - 1) / boundary * boundary);
  if (memory == nullptr) {
    throw std::bad_alloc();
  }
  ++live;
  return memory;
}

void release(void* memory) {
  if (memory != nullptr) {
    --live;
  }
  std::free(memory);
}

}  // namespace

FailingAllocation::FailingAllocation(long n) {
  until_failure = n;
  has_failed = false;
}

FailingAllocation::~FailingAllocation() {
  until_failure = 0;
}

bool FailingAllocation::happened() const {
  return has_failed;
}

FailingAllocation::Counting::Counting() {
  counts = true;
}

FailingAllocation::Counting::~Counting() {
  counts = false;
}

long liveAllocations() {
  return live;
}

}  // namespace cobot_command::allocation

using cobot_command::allocation::allocate;
using cobot_command::allocation::allocateAligned;
using cobot_command::allocation::release;

void* operator new(std::size_t size) {
  return allocate(size);
}
void* operator new[](std::size_t size) {
  return allocate(size);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocateAligned(size, alignment);
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return allocateAligned(size, alignment);
}
// Who asks in this way can do without: it never fails here.
void* operator new(std::size_t size, const std::nothrow_t& /*may fail*/) noexcept {
  void* const memory = std::malloc(size);
  cobot_command::allocation::live += memory != nullptr ? 1 : 0;
  return memory;
}

void operator delete(void* memory) noexcept {
  release(memory);
}
void operator delete[](void* memory) noexcept {
  release(memory);
}
void operator delete(void* memory, std::size_t /*size*/) noexcept {
  release(memory);
}
void operator delete[](void* memory, std::size_t /*size*/) noexcept {
  release(memory);
}
void operator delete(void* memory, const std::nothrow_t& /*may fail*/) noexcept {
  release(memory);
}
void operator delete(void* memory, std::align_val_t /*alignment*/) noexcept {
  release(memory);
}
void operator delete[](void* memory, std::align_val_t /*alignment*/) noexcept {
  release(memory);
}
void operator delete(void* memory, std::size_t /*size*/, std::align_val_t /*alignment*/) noexcept {
  release(memory);
}
void operator delete[](void* memory, std::size_t /*size*/, std::align_val_t /*alignment*/) noexcept {
  release(memory);
}
