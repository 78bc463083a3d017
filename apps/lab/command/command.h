#pragma once

#include "engine/core/result.h"

#include <QJsonObject>
#include <QStringList>

#include <span>
#include <vector>

namespace carina::lab
{

class Words;

/// An option of a command, declared once: the parser, the help and the code that asks for its value
/// all take this.
struct Option {
    const char* name;     ///< without its dashes: "fle"
    const char* value;    ///< what the help calls its value, with the unit: "MM"; "" for a switch
    const char* help;     ///< what it is for, its bounds, and what holds where it is not given
    bool repeats = false; ///< it may be given several times
};

/// A key of the object that a command prints, declared once: it stands in the help, and where the
/// object is made it takes the place of a string.
struct Key {
    const char* name;
    const char* help;
    int depth = 0; ///< 1 for a key of the objects that the last key of depth 0 holds, and so on

    [[nodiscard]] operator QString() const { return QString::fromLatin1(name); }
};

/// A line of a page that is neither option nor key: a file that is read, or an example.
struct Note {
    const char* name;
    const char* help;
};

/// One way to use a command, with an object of its own.
struct Use {
    std::vector<const char*> lines; ///< of the command line, after the command's name
    const char* text;               ///< what it does, in whole sentences; broken into lines by help
    std::vector<Note> notes{};      ///< files and examples
    std::vector<Option> options{};
    Key schema{"schema", ""}; ///< its help is the value, such as "carina.tre/1"
    std::vector<Key> keys{};
};

/// A command of carina-lab: its page, and what it does. An experiment prints one JSON object.
struct Command {
    const char* name;    ///< first word of the command line
    const char* theme;   ///< under which `carina-lab help` lists it; "" for one not for people
    const char* summary; ///< one line there
    std::vector<Use> uses;
    qsizetype mostFiles = 0;   ///< how many words it takes that are no options
    const char* reminder = ""; ///< ends each refusal of a command line: what it needs
    bool draws = false;        ///< needs a display
    Result<QJsonObject> (*experiment)(const Words& words);

    /// Reads the words after the name and runs the experiment.
    /// @returns WrongOption with a sentence about the words that are wrong; the error of
    ///          the experiment
    [[nodiscard]] Result<QJsonObject> run(const QStringList& arguments) const;
};

/// The key of what a command warns of, an array of sentences: they go to stderr, too.
inline constexpr Key kWarnings{"warnings", "sentences about what may be wrong; on stderr, too"};

/// The key of whether a result may be used; where it is false, the exit status is 1.
inline constexpr Key kAcceptable{"acceptable",
                                 "whether the result may be used; if not, the exit status is 1"};

/// An object as it is printed. Numbers have twelve significant digits: more are noise of rounding,
/// such as 0.30000000000000004. Those of a million and more have six decimals: a time in seconds
/// since 1970 keeps its microseconds.
[[nodiscard]] QByteArray printed(const QJsonObject& object);

/// Runs carina-lab, which has these commands, on a whole command line: prints the object on stdout
/// and returns 0 (1 where its kAcceptable is false), or one sentence on stderr and returns 1. Words
/// that cannot be used (WrongOption, and a command there is not) return 2, with a second sentence
/// that names the help. With --help anywhere after the name, or help before it, prints the page of
/// the command.
int runCommandLine(std::span<const Command> commands, const QStringList& arguments);

} // namespace carina::lab
