#include <iostream>
#include <string>
#include <vector>

#include "plugin/application.h"
#include "plugin/interrupt.h"

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  const octacut::InterruptHandler interrupt;
  return octacut::RunApplication(arguments,
                                 octacut::CommandRegistry(),
                                 std::cout,
                                 std::cerr,
                                 &interrupt.Requested());
}
