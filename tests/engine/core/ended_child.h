#pragma once

#include <string>
#include <sys/wait.h>
#include <unistd.h>

namespace carina::test
{

/// Whether this is a child of endOfChild.
inline bool isEndingChild = false;

struct EndedChild {
    int status = 0;   ///< as waitpid gives it
    std::string said; ///< what it wrote into its pipe
};

/// Runs `work` in a child of its own, for what ends a program, and waits for its end.
/// @param work takes the end of the pipe to write into; does not return
template <class Work> EndedChild endOfChild(const Work& work)
{
    int pipeEnds[2];
    if (pipe(pipeEnds) != 0)
        return {};
    const pid_t child = fork();
    if (child == 0) {
        isEndingChild = true;
        work(pipeEnds[1]);
    }
    close(pipeEnds[1]);
    EndedChild end;
    char letter = 0;
    while (read(pipeEnds[0], &letter, 1) == 1)
        end.said += letter;
    close(pipeEnds[0]);
    waitpid(child, &end.status, 0);
    return end;
}

} // namespace carina::test
