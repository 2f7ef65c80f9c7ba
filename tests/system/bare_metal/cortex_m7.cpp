// Start of a Cortex-M7 without an operating system, and text through semihosting (Arm IHI 0071, "Semihosting for
// AArch32"). No start files and no system calls of the C library are linked.

#include <cstddef>
#include <cstdint>

#include "machine.hpp"

extern "C" {
extern std::uint32_t bss_start[], bss_end[], stack_limit[], stack_top[];  // cortex_m7.ld
[[noreturn]] void start();
[[noreturn]] void fault();
}

namespace {

constexpr std::uint32_t kWrite0 = 0x04, kExit = 0x18, kExitDone = 0x20026, kExitFailed = 0x20023;
constexpr std::uint32_t kPaint = 0x5afe57ac;

std::uint32_t semihosting(std::uint32_t operation, std::uint32_t argument) noexcept {
  register std::uint32_t r0 asm("r0") = operation;
  register std::uint32_t r1 asm("r1") = argument;
  asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}

[[noreturn]] void leave(std::uint32_t reason) noexcept {
  semihosting(kExit, reason);
  while (true) {
  }
}

std::uint32_t* stack_pointer() noexcept {
  std::uint32_t* pointer;
  asm volatile("mov %0, sp" : "=r"(pointer));
  return pointer;
}

void put_decimal(std::uint32_t number) noexcept {
  char text[11];
  char* place = text + sizeof text - 1;
  for (*place = 0; place == text + sizeof text - 1 || number > 0; number /= 10) {
    *--place = static_cast<char>('0' + number % 10);
  }
  put(place);
}

/// Runs on a painted stack and says how much of it was used.
void run_measured() noexcept {
  std::uint32_t* const here = stack_pointer() - 16;
  for (std::uint32_t* word = stack_limit; word < here; ++word) *word = kPaint;
  run();
  const std::uint32_t* untouched = stack_limit;
  while (untouched < here && *untouched == kPaint) ++untouched;
  put("stack ");
  put_decimal(
      static_cast<std::uint32_t>(reinterpret_cast<const char*>(here) - reinterpret_cast<const char*>(untouched)));
  put("\n");
}

}  // namespace

void put(const char* text) noexcept { semihosting(kWrite0, reinterpret_cast<std::uintptr_t>(text)); }

void start() {
  // Coprocessor access control register: full access to the floating-point unit, before its first use.
  auto* const access = reinterpret_cast<volatile std::uint32_t*>(0xe000ed88);
  *access = *access | (0xfu << 20);
  asm volatile("dsb\n isb" : : : "memory");
  for (std::uint32_t* word = bss_start; word < bss_end; ++word) *word = 0;
  run_measured();
  leave(kExitDone);
}

void fault() {
  put("fault\n");
  leave(kExitFailed);
}

/// Initial stack pointer, reset, and the fifteen exceptions of the processor.
struct Vectors {
  const void* stack;
  void (*handlers[15])();
};
extern "C" __attribute__((section(".vectors"), used)) const Vectors vectors = {
    stack_top,
    {start, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault}};
