#include "apps/lab/commands.h"
#include "apps/lab/drift/launcher_pipe.h"
#include "apps/lab/drift/live_participant.h"
#include "engine/core/monotonic_clock.h"

#include <thread>

namespace carina::lab
{
namespace
{

// One program of `carina-lab drift --live`, which starts it and speaks with it over its standard
// input and output:
//
//     in:  the orders, one line (LiveOrders)
//     out: "port <n>" of the host
//     out: "ready" when it shows both objects at rest
//     in:  "start <ns>", the machine's CLOCK_MONOTONIC of the first action
//     out: its log (LiveLog), a JSON object
//
// It ends when its standard input does, so that none outlives the one that started it.

constexpr Duration kPatience = std::chrono::seconds{60};
/// How long it goes on after the last action.
constexpr Duration kAfter = std::chrono::milliseconds{1500};

tl::unexpected<Error> leftAlone()
{
    return fail(Errc::Cancelled, "drift-node: the program that started this one has ended.");
}

LocalTime machineNow() { return machineTime(monotonicNow()); }

void sleepUntil(LocalTime machine)
{
    std::this_thread::sleep_until(std::chrono::steady_clock::time_point{
        std::chrono::duration_cast<std::chrono::steady_clock::duration>(
            machine.time_since_epoch())});
}

/// Waits for a line, and does something meanwhile.
template <class Meanwhile>
Result<QByteArray> waitForLine(LauncherPipe& launcher, Meanwhile meanwhile)
{
    for (;;) {
        if (const auto line = launcher.line())
            return *line;
        if (launcher.isClosed())
            return leftAlone();
        meanwhile();
        sleepUntil(machineNow() + LiveParticipant::kSampleInterval);
    }
}

Result<void> comeIn(LauncherPipe& launcher, LiveParticipant& participant)
{
    const LocalTime end = machineNow() + kPatience;
    while (!participant.comeIn()) {
        static_cast<void>(launcher.line()); // none comes so early
        if (launcher.isClosed())
            return leftAlone();
        if (machineNow() > end) {
            const auto why = participant.refusal();
            return fail(why ? why->code : Errc::NotPermitted,
                        "drift-node: was not admitted to the session.");
        }
        sleepUntil(machineNow() + LiveParticipant::kSampleInterval);
    }
    LauncherPipe::say("ready");
    return {};
}

Result<void> takePart(LauncherPipe& launcher, LiveParticipant& participant, LocalTime begin,
                      LocalTime end)
{
    participant.beginAt(begin);
    while (participant.nextStep() < end) {
        sleepUntil(participant.nextStep());
        static_cast<void>(launcher.line());
        if (launcher.isClosed())
            return leftAlone();
        participant.step();
    }
    return {};
}

Result<QJsonObject> driftNode(const Words&)
{
    LauncherPipe launcher;
    const auto line = waitForLine(launcher, [] {});
    const auto orders = line ? ordersIn(*line) : tl::unexpected(line.error());
    if (!orders)
        return tl::unexpected(orders.error());
    const auto participant = LiveParticipant::start(*orders);
    if (!participant)
        return tl::unexpected(participant.error());
    if (orders->part == LiveOrders::Part::Host)
        LauncherPipe::say("port " + QByteArray::number((*participant)->port()));
    if (const auto in = comeIn(launcher, **participant); !in)
        return tl::unexpected(in.error());

    const auto start = waitForLine(launcher, [] {});
    if (!start)
        return tl::unexpected(start.error());
    const LocalTime begin{Duration{start->mid(qsizetype{6}).toLongLong()}}; // "start <ns>"
    const LocalTime end = begin + ActionScript::startOf(orders->script.actions) + kAfter;
    if (const auto taken = takePart(launcher, **participant, begin, end); !taken)
        return tl::unexpected(taken.error());
    return toJson((*participant)->log());
}

} // namespace

Command driftNodeCommand()
{
    return {
        .name = "drift-node",
        .theme = "",
        .summary = "a program of drift --live",
        .uses =
            {{.lines = {""},
              .text =
                  "One program of 'drift --live', which starts it and communicates with it over "
                  "its standard input and output. It is not meant to be started by hand."}},
        .experiment = driftNode};
}

} // namespace carina::lab
