// What a program takes, as data; and the three scripts made of it.
// SPDX-License-Identifier: MIT
#include "tools/shared/completion.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <vector>

#include "base/error.hpp"

namespace rmpl::tools {
namespace {

struct ListedOption {
  std::vector<std::string> names;  ///< `-o`, `--output`
  std::vector<std::string> words;  ///< what it takes, where these are few words
  std::string takes;               ///< what it takes, as help calls it; empty for a flag
  std::string description;
};

struct ListedCommand {
  std::string name;
  std::string description;
  std::vector<ListedOption> options;
};

/// `text|json` is `text`, `json`; `OUT.json` is no choice.
std::vector<std::string> words_of(const std::string& text) {
  if (text.find('|') == std::string::npos) return {};
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (c == '|') {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  return words;
}

ListedCommand command_of(const CLI::App& app) {
  ListedCommand command{app.get_name(), app.get_description(), {}};
  for (const CLI::Option* option : app.get_options([](const CLI::Option* o) { return !o->get_positional(); })) {
    ListedOption& made = command.options.emplace_back();
    for (const std::string& name : option->get_snames()) made.names.push_back("-" + name);
    for (const std::string& name : option->get_lnames()) made.names.push_back("--" + name);
    made.description = option->get_description();
    if (option->get_expected_max() == 0) continue;
    made.takes = option->get_option_text().empty() ? option->get_type_name() : option->get_option_text();
    made.words = words_of(made.takes);
  }
  return command;
}

/// Their options without those that the program has everywhere.
std::vector<ListedCommand> subcommands_of(const CLI::App& app) {
  const ListedCommand top = command_of(app);
  const auto everywhere = [&](const ListedOption& option) {
    return std::any_of(top.options.begin(), top.options.end(),
                       [&](const ListedOption& o) { return o.names == option.names; });
  };
  std::vector<ListedCommand> all;
  for (const CLI::App* inner : app.get_subcommands([](const CLI::App*) { return true; })) {
    all.push_back(command_of(*inner));
    std::erase_if(all.back().options, everywhere);
  }
  return all;
}

std::string joined(const std::vector<std::string>& parts, std::string_view between) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : std::string(between)) + part;
  return text;
}

/// In single quotes, for a shell; `special` gets a backslash before it.
std::string quoted(const std::string& text, std::string_view special, std::string_view quote) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'') {
      result += quote;
    } else {
      result += (special.find(c) == std::string_view::npos ? "" : "\\") + std::string(1, c);
    }
  }
  return result + "'";
}

std::string header(const std::string& program, const char* shell) {
  return "# " + std::string(shell) + " completion of " + program + ", written from its options.\n";
}

/// In bash the name of a function may have no hyphen.
std::string function_name(const std::string& program) {
  std::string name = "_" + program;
  for (char& c : name) c = c == '-' ? '_' : c;
  return name;
}

/// The cases that complete what an option takes; without words these are names of files, which bash adds itself.
std::string bash_values(const std::string& command, const ListedCommand& of) {
  std::string text;
  for (const ListedOption& option : of.options) {
    if (option.takes.empty()) continue;
    std::vector<std::string> patterns;
    for (const std::string& name : option.names) patterns.push_back(command + "," + name);
    text += "    " + joined(patterns, "|") + ")\n";
    if (!option.words.empty())
      text += "      COMPREPLY=($(compgen -W '" + joined(option.words, " ") + "' -- \"$current\"))\n";
    text += "      return ;;\n";
  }
  return text;
}

std::string bash_words(const ListedCommand& command) {
  std::vector<std::string> names;
  for (const ListedOption& option : command.options)
    names.insert(names.end(), option.names.begin(), option.names.end());
  return joined(names, " ");
}

std::string bash(const CLI::App& app) {
  const ListedCommand top = command_of(app);
  const std::vector<ListedCommand> commands = subcommands_of(app);
  std::vector<std::string> names;
  for (const ListedCommand& command : commands) names.push_back(command.name);
  const std::string function = function_name(top.name);
  std::string text = header(top.name, "bash") + function + R"(() {
  local current=${COMP_WORDS[COMP_CWORD]} option=${COMP_WORDS[COMP_CWORD-1]} command='' words='' word
  if [[ $current == = ]]; then
    current=''
  elif [[ $option == = ]]; then
    option=${COMP_WORDS[COMP_CWORD-2]}
  fi
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    case $word in
      )" + joined(names, "|") +
                     R"()
        command=$word
        break ;;
    esac
  done
  COMPREPLY=()
  case $command,$option in
)";
  for (const ListedCommand& command : commands) text += bash_values(command.name, command);
  text += bash_values("*", top) + "  esac\n  case $command in\n";
  for (const ListedCommand& command : commands) {
    text += "    " + command.name + ") words='" + bash_words(command) + "' ;;\n";
  }
  text += "    *) words='" + joined(names, " ") + "' ;;\n  esac\n";
  text += "  if [[ $current == -* || -z $command ]]; then\n    COMPREPLY=($(compgen -W \"$words " + bash_words(top) +
          "\" -- \"$current\"))\n  fi\n}\ncomplete -o bashdefault -o default -F " + function + " " + top.name + "\n";
  return text;
}

/// The specifications of `_arguments`, a line each.
std::string zsh_options(const ListedCommand& command, const std::string& indent) {
  std::string text;
  for (const ListedOption& option : command.options) {
    std::string takes;
    if (!option.takes.empty()) {
      takes = option.words.empty() ? ":" + option.takes + ":_files" : ":word:(" + joined(option.words, " ") + ")";
    }
    const std::string others = option.names.size() > 1 ? "(" + joined(option.names, " ") + ")" : "";
    for (const std::string& name : option.names) {
      const bool is_long = name.starts_with("--");
      text += indent + quoted(others + name + (takes.empty() ? "" : is_long ? "=" : "+"), "", "'\\''");
      std::string escaped;
      for (const char c : option.description)
        escaped += (c == '[' || c == ']' || c == ':' ? "\\" : "") + std::string(1, c);
      text += quoted("[" + escaped + "]" + takes, "", "'\\''") + " \\\n";
    }
  }
  return text;
}

std::string zsh(const CLI::App& app) {
  const ListedCommand top = command_of(app);
  const std::vector<ListedCommand> commands = subcommands_of(app);
  const std::string function = "_" + top.name;  // also the name of the file, by which it is loaded
  std::string text = "#compdef " + top.name + "\n" + header(top.name, "zsh") + function +
                     "() {\n  local context state state_descr line\n  typeset -A opt_args\n  local -a commands=(\n";
  for (const ListedCommand& command : commands) {
    text += "    " + quoted(command.name + ":" + command.description, "", "'\\''") + "\n";
  }
  text += "  )\n  _arguments -C \\\n" + zsh_options(top, "    ") +
          "    '1:subcommand:->command' \\\n    '*::argument:->arguments'\n  case $state in\n    command) _describe "
          "subcommand "
          "commands ;;\n    arguments)\n      case $line[1] in\n";
  for (const ListedCommand& command : commands) {
    text += "        " + command.name + ")\n          _arguments \\\n" + zsh_options(command, "            ") +
            zsh_options(top, "            ") + "            '*:file:_files' ;;\n";
  }
  // Loaded by name the file is the function, and runs it; read as a script it names it to the completion system.
  return text + "      esac ;;\n  esac\n}\nif [[ $funcstack[1] == " + function + " ]]; then\n  " + function +
         " \"$@\"\nelse\n  compdef " + function + " " + top.name + "\nfi\n";
}

std::string fish_options(const std::string& start, const ListedCommand& command) {
  std::string text;
  for (const ListedOption& option : command.options) {
    text += start;
    for (const std::string& name : option.names) {
      text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    }
    if (!option.words.empty()) {
      text += " -x -a '" + joined(option.words, " ") + "'";
    } else if (!option.takes.empty()) {
      text += " -r";
    }
    text += " -d " + quoted(option.description, "\\", "\\'") + "\n";
  }
  return text;
}

std::string fish(const CLI::App& app) {
  const ListedCommand top = command_of(app);
  const std::string start = "complete -c " + top.name;
  std::string text = header(top.name, "fish") + fish_options(start, top);
  for (const ListedCommand& command : subcommands_of(app)) {
    text += start + " -n __fish_use_subcommand -f -a " + command.name + " -d " +
            quoted(command.description, "\\", "\\'") + "\n" +
            fish_options(start + " -n '__fish_seen_subcommand_from " + command.name + "'", command);
  }
  return text;
}

}  // namespace

std::string completion(const CLI::App& app, std::string_view shell) {
  if (shell == "bash") return bash(app);
  if (shell == "zsh") return zsh(app);
  if (shell == "fish") return fish(app);
  throw base::InputError("expected the shell bash, zsh or fish, not '" + std::string(shell) + "'");
}

}  // namespace rmpl::tools
