#include "apps/lab/attack/guests.h"

#include "apps/lab/attack/attackers/attendee.h"
#include "apps/lab/attack/derived_once.h"
#include "apps/lab/commands.h"
#include "apps/lab/drift/launcher_pipe.h"
#include "engine/core/monotonic_clock.h"

#include <QCoreApplication>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTimer>

#include <array>
#include <thread>
#include <utility>
#include <vector>

#include <sys/resource.h>

namespace carina::lab
{
namespace
{

using namespace std::chrono_literals;

constexpr std::array kRoles{Role::Instructor, Role::Trainee, Role::Observer};
constexpr Duration kPatience = 30s; ///< until one is in
constexpr auto kLook = 10ms;
constexpr int kGoing_ms = 5000;
// Of ten guests one is an instructor, two are observers, and the others trainees: so 235 guests,
// the attackers and who comes new are fewer of each role than may be present from one address
// (mostPresentFrom).
constexpr int kOfTen = 10;
constexpr int kInstructorsOfTen = 1;
constexpr int kObserversOfTen = 2;

Role roleOfGuest(int number)
{
    const int place = number % kOfTen;
    if (place < kInstructorsOfTen)
        return Role::Instructor;
    return place < kInstructorsOfTen + kObserversOfTen ? Role::Observer : Role::Trainee;
}

QString wordOf(Role role)
{
    const std::string_view word = roleWord(role);
    return QString::fromUtf8(word.data(), qsizetype(word.size()));
}

struct Orders {
    std::uint16_t port = 0;
    int count = 0;
    JoinCodes codes;
};

QByteArray lineOf(const Orders& orders)
{
    QJsonObject object{{QStringLiteral("port"), orders.port},
                       {QStringLiteral("count"), orders.count}};
    for (const Role role : kRoles)
        object[wordOf(role)] = QString::fromStdString(orders.codes.at(role).text());
    return QJsonDocument{object}.toJson(QJsonDocument::Compact) + '\n';
}

Result<Orders> ordersOf(const QByteArray& line)
{
    const QJsonObject object = QJsonDocument::fromJson(line).object();
    Orders orders{static_cast<std::uint16_t>(object[QStringLiteral("port")].toInt()),
                  object[QStringLiteral("count")].toInt(),
                  {}};
    for (const Role role : kRoles) {
        const auto code = JoinCode::parse(object[wordOf(role)].toString().toStdString());
        if (!code)
            return tl::unexpected(code.error());
        orders.codes.emplace(role, *code);
    }
    return orders;
}

tl::unexpected<Error> leftAlone()
{
    return fail(Errc::Cancelled, "guests: the program that started this one has ended.");
}

/// Guests in the event loop of this thread, as many clients as there are people.
class Attendance
{
public:
    explicit Attendance(const Orders& orders) : m_orders{orders} {}

    [[nodiscard]] bool isComplete() const { return m_in == m_orders.count; }
    /// Waits for the next, and serves those who are there.
    Result<void> step()
    {
        const LocalTime now = monotonicNow();
        if (!isComplete() && m_in == int(m_guests.size())) {
            const Role role = roleOfGuest(m_in);
            m_guests.push_back(std::make_unique<Attendee>(
                WayIn{m_orders.port, role, m_orders.codes.at(role), m_derive},
                Guests::nameOf(m_in)));
            m_asksSince = now;
        }
        for (const auto& guest : m_guests)
            guest->attends();
        if (!isComplete() && m_guests.back()->intruder().takesPart())
            ++m_in;
        else if (!isComplete() && now > m_asksSince + kPatience)
            return fail(Errc::HostSilent, Guests::nameOf(m_in) + " did not come in");
        return {};
    }

private:
    Orders m_orders;
    DeriveKey m_derive = derivedOnce();
    std::vector<std::unique_ptr<Attendee>> m_guests;
    int m_in = 0; // of these; all but the last
    LocalTime m_asksSince{};
};

Result<QJsonObject> attend(const Words&)
{
    LauncherPipe launcher;
    std::optional<QByteArray> line;
    while (!(line = launcher.line())) {
        if (launcher.isClosed())
            return leftAlone();
        std::this_thread::sleep_for(kLook);
    }
    const auto orders = ordersOf(*line);
    if (!orders)
        return tl::unexpected(orders.error());
    Attendance attendance{*orders};
    Result<void> stepped;
    bool hasSaid = false;
    QTimer look;
    look.callOnTimeout([&] {
        static_cast<void>(launcher.line());
        stepped = attendance.step();
        if (attendance.isComplete() && !std::exchange(hasSaid, true))
            LauncherPipe::say("ready");
    });
    look.start(kLook);
    while (!launcher.isClosed() && stepped)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    return stepped ? leftAlone() : tl::unexpected(stepped.error());
}

} // namespace

Guests::Guests(std::uint16_t port, const JoinCodes& codes, int count)
{
    m_process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    m_process.setChildProcessModifier([] {
        constexpr int kLowerBy = 5; // a third of the share of the host's and the attackers' threads
        setpriority(PRIO_PROCESS, 0, kLowerBy);
    });
    m_process.start(QCoreApplication::applicationFilePath(), {QStringLiteral("guests")});
    m_process.write(lineOf({port, count, codes}));
}

Guests::~Guests()
{
    m_process.kill(); // a program that says nothing any more is away, too
    m_process.waitForFinished(kGoing_ms);
}

bool Guests::areIn()
{
    while (!m_areIn && m_process.canReadLine())
        m_areIn = m_process.readLine().trimmed() == "ready";
    return m_areIn;
}

Command guestsCommand()
{
    return {.name = "guests",
            .theme = "",
            .summary = "the guests of attack",
            .uses = {{.lines = {""},
                      .text = "The guests of 'attack', which starts this program and communicates "
                              "with it over its standard input and output. It is not meant to be "
                              "started by hand."}},
            .experiment = attend};
}

} // namespace carina::lab
