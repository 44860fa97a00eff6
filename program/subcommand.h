// SPDX-License-Identifier: MIT
// One command of the program, `reorient COMMAND ...`: its parser and its function.
#pragma once

#include <functional>
#include <iosfwd>

namespace CLI {
class App;
}

namespace reorient {

struct Subcommand {
  CLI::App* parser = nullptr;  ///< knows whether the command was given
  /// Returns the exit code. Throws std::exception with one line on bad input.
  std::function<int(std::ostream& out, std::ostream& err)> run;
};

// Each adds itself to the program's parser.
Subcommand add_run(CLI::App& program);
Subcommand add_test(CLI::App& program);
Subcommand add_experiment(CLI::App& program);
Subcommand add_calibrate(CLI::App& program);
Subcommand add_check(CLI::App& program);
Subcommand add_complete(CLI::App& program);
Subcommand add_game(CLI::App& program);
Subcommand add_graph(CLI::App& program);
Subcommand add_help(CLI::App& program);
Subcommand add_list(CLI::App& program);
Subcommand add_look(CLI::App& program);
Subcommand add_params(CLI::App& program);
Subcommand add_recording(CLI::App& program);
Subcommand add_reference(CLI::App& program);
Subcommand add_model(CLI::App& program);
Subcommand add_new(CLI::App& program);
Subcommand add_record_test(CLI::App& program);
Subcommand add_replay(CLI::App& program);
Subcommand add_room(CLI::App& program);
Subcommand add_version(CLI::App& program);

}  // namespace reorient
