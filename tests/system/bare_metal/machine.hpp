#pragma once
// Functions that run.cpp needs of a machine: cortex_m7.cpp or host.cpp.

/// Writes a text, which ends with a zero.
void put(const char* text) noexcept;

/// The work itself, in run.cpp.
void run() noexcept;
