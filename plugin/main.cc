#include <csignal>
#include <iostream>
#include <string>
#include <vector>

#include "plugin/application.h"
#include "plugin/interrupt.h"

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  // A file beyond the limit of its size then fails as on a full disk does.
  std::signal(SIGXFSZ, SIG_IGN);
  const octacut::InterruptHandler interrupt;
  return octacut::RunApplication(arguments,
                                 octacut::CommandRegistry(),
                                 std::cout,
                                 std::cerr,
                                 &interrupt.Requested());
}
