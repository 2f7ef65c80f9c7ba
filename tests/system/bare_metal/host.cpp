// The machine that the tests run on.

#include <cstdio>

#include "machine.hpp"

void put(const char* text) noexcept { std::fputs(text, stdout); }

int main() { run(); }
