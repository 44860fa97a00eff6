// SPDX-License-Identifier: MIT
// `reorient complete WORD...`: the candidates for the last word, for assets/completion. Not listed in the help.
#include <ostream>

#include <CLI/CLI.hpp>

#include "engine/parameters/utf8.h"
#include "program/program.h"
#include "program/shell/completion.h"
#include "program/subcommand.h"

namespace reorient {

Subcommand add_complete(CLI::App& program) {
  CLI::App* const parser = program.add_subcommand("complete", "print what may follow on a command line")->group("");
  parser->set_help_flag();
  parser->prefix_command();  // the words are those of another command line
  return {parser, [parser, &program](std::ostream& out, std::ostream&) {
            const Completion completion = completion_of(program, parser->remaining());
            for (const Completion::Candidate& candidate : completion.candidates)
              out << as_line(candidate.word) << '\t' << as_line(candidate.text) << '\n';
            if (completion.files) out << "\tfiles\n";
            if (completion.folders) out << "\tfolders\n";
            return kSuccess;
          }};
}

}  // namespace reorient
