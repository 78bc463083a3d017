#include "apps/lab/scene/scene_experiment.h"

#include "apps/lab/scene/own_display.h"
#include "apps/lab/scene/scene_network.h"
#include "engine/core/monotonic_clock.h"
#include "engine/session/facts/facts.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTimer>
#include <QUdpSocket>

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

namespace carina::lab
{
namespace
{

constexpr Duration kScenePatience =
    std::chrono::minutes{4}; ///< for all to be in, on a busy machine
constexpr Duration kPicturePatience = std::chrono::seconds{60};
constexpr Duration kSettled = std::chrono::seconds{4}; ///< after people have chosen places
constexpr Duration kSceneLook = std::chrono::milliseconds{200};
constexpr int kSceneWake_ms = 50;
constexpr double kLongestFrameGap = 0.3; ///< seconds, between which an owner's pose is interpolated
constexpr int kThreePeople = 3;

/// Who takes part beside the console.
struct SceneGuest {
    const char* name;
    const char* station;
    const char* patient;
    bool isRemote = false;
};
constexpr const char* kFirstStation = "Station 1";
constexpr const char* kSecondStation = "Room 2";
constexpr std::array kSceneGuests{SceneGuest{"Anna", kFirstStation, "child"},
                                  SceneGuest{"Ben", kFirstStation, "child"},
                                  SceneGuest{"Clara", kFirstStation, "child", true},
                                  SceneGuest{"David", kSecondStation, "adult"},
                                  SceneGuest{"Emma", kSecondStation, "adult"},
                                  SceneGuest{"Finn", kSecondStation, "adult", true}};

/// The last line of a journal, as far as it is whole.
QJsonObject lastLine(const QString& journal)
{
    constexpr qint64 kTail = 400'000;
    QFile file{journal};
    if (!file.open(QIODevice::ReadOnly))
        return {};
    file.seek(std::max<qint64>(0, file.size() - kTail));
    const QByteArrayList lines = file.readAll().split('\n');
    return lines.size() < 2 ? QJsonObject{}
                            : QJsonDocument::fromJson(lines[lines.size() - 2]).object();
}

double sessionTimeOf(const QString& journal)
{
    return 1e-9 * double(lastLine(journal)[QStringLiteral("session_ns")].toInteger());
}

/// A program with its files.
struct ScenePartner {
    QString name;
    QString folder; ///< of its own
    std::unique_ptr<OwnDisplay> display = std::make_unique<OwnDisplay>();
    std::unique_ptr<WatchedProgram> program{};
    bool hasSeenAll = false;

    [[nodiscard]] QString file(const char* what) const
    {
        return QDir{folder}.filePath(QLatin1StringView{what});
    }
    [[nodiscard]] QString journal() const { return file("journal"); }
    /// Whether its last line has a frame that drew the tubes of all three at its station.
    [[nodiscard]] bool seesAll() const
    {
        const QJsonArray frames = lastLine(journal())[QStringLiteral("frames")].toArray();
        if (frames.isEmpty())
            return false;
        int tubes = 0;
        for (const QJsonValue& object : frames.last()[QStringLiteral("objects")].toArray())
            tubes += object[QStringLiteral("kind")].toInt() == int(ObjectKind::Tube) ? 1 : 0;
        return tubes == kThreePeople;
    }
    void work(const QString& line) const
    {
        QFile script{file("script")};
        if (script.open(QIODevice::Append))
            script.write(line.toUtf8() + '\n');
    }
};

/// Of a path; of one that a trace describes, that of its points.
Duration meanDelay(const PathProfile& path)
{
    if (!path.trace)
        return path.jitter == PathProfile::Jitter::Exponential ? path.delay + path.jitterScale
               : path.jitter == PathProfile::Jitter::Pareto    ? path.delay + path.jitterScale / 2
                                                               : path.delay;
    Duration sum{};
    int count = 0;
    for (const TracePoint& point : *path.trace)
        if (point.delay) {
            sum += *point.delay;
            ++count;
        }
    return count > 0 ? sum / count : sum;
}

std::uint16_t freeScenePort()
{
    QUdpSocket probe;
    probe.bind(QHostAddress::LocalHost);
    return probe.localPort();
}

class SceneRun
{
public:
    explicit SceneRun(const SceneSettings& settings) : m_settings{settings}
    {
        m_wake.start(kSceneWake_ms);
    }

    Result<SceneFigures> run()
    {
        return connectAll()
            .and_then([&] { return startAll(); })
            .and_then([&] { return watch(); })
            .and_then([&] { return takePictures(); })
            .map([&] { return evaluate(); });
    }

private:
    Result<void> connectAll()
    {
        SceneNetworkSettings settings{.participants = int(kSceneGuests.size()),
                                      .scenario = m_settings.scenario,
                                      .seed = m_settings.seed,
                                      .hostPort = m_port};
        for (std::size_t i = 0; i < kSceneGuests.size(); ++i)
            if (kSceneGuests[i].isRemote)
                settings.remote.insert(int(i) + 1);
        if (m_settings.netlab.isEmpty()) {
            m_network = relayedSceneNetwork(settings);
            return {};
        }
        return netlabSceneNetwork(m_settings.netlab, settings).map([&](auto network) {
            m_network = std::move(network);
        });
    }

    /// Works the event loop, in which the relays are, until something holds, which is looked at a
    /// few times a second.
    Result<void> waitUntil(Duration patience, const std::string& what,
                           const std::function<bool()>& holds)
    {
        const LocalTime deadline = monotonicNow() + patience;
        LocalTime nextLook = LocalTime::min();
        for (;; QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents)) {
            if (monotonicNow() < nextLook)
                continue;
            for (const ScenePartner& player : m_players)
                if (player.program && player.program->hasEnded())
                    return fail(Errc::HostSilent,
                                "the program of " + player.name.toStdString() + " has ended");
            if (holds())
                return {};
            if (monotonicNow() > deadline)
                return fail(Errc::HostSilent, what);
            nextLook = monotonicNow() + kSceneLook;
        }
    }

    Result<void> letPass(Duration time)
    {
        const LocalTime end = monotonicNow() + time;
        return waitUntil(time + kPicturePatience, "the time has stopped",
                         [&] { return monotonicNow() >= end; });
    }

    /// Starts a program and waits until it shows something of the session.
    Result<void> start(const QString& name, const QString& program, const QStringList& more)
    {
        if (!QFile::exists(program))
            return fail(Errc::FileNotFound, program.toStdString());
        const int who = int(m_players.size());
        ScenePartner& player = m_players.emplace_back();
        player.name = name;
        player.folder = m_folder.filePath(QString::number(who));
        QDir{}.mkpath(player.folder);
        if (const auto shown = player.display->start(m_settings.size); !shown)
            return shown;
        const QStringList words =
            QStringList{
                program,
                QStringLiteral("--data"),
                player.folder,
                QStringLiteral("--journal"),
                player.journal(),
                QStringLiteral("--script"),
                player.file("script"),
                QStringLiteral("--size"),
                QStringLiteral("%1x%2").arg(m_settings.size.width()).arg(m_settings.size.height())}
            + more;
        player.program = std::make_unique<WatchedProgram>(
            name.toStdString(), m_network->inPlace(who, player.display->on(words)));
        return waitUntil(kScenePatience, name.toStdString() + " does not come in",
                         [&] { return !lastLine(player.journal()).isEmpty(); });
    }

    Result<void> startConsole()
    {
        const QStringList words{QStringLiteral("--port"),
                                QString::number(m_port),
                                QStringLiteral("--new"),
                                QStringLiteral("--start"),
                                QStringLiteral("--codes"),
                                codes(),
                                QStringLiteral("--patient"),
                                QStringLiteral("child"),
                                QStringLiteral("--add-station"),
                                QStringLiteral("%1: adult").arg(QLatin1StringView{kSecondStation})};
        return start(QStringLiteral("Console"), m_settings.programs.console,
                     words + m_network->consoleOptions());
    }

    Result<void> startGuest(int number, const SceneGuest& guest)
    {
        const auto door = m_network->doorOf(number);
        return start(QLatin1StringView{guest.name}, m_settings.programs.trainee,
                     {QStringLiteral("--as"), QLatin1StringView{guest.name},
                      QStringLiteral("--station"), QLatin1StringView{guest.station},
                      QStringLiteral("--host"), door.address, QStringLiteral("--port"),
                      QString::number(door.port), QStringLiteral("--code-file"), codes(),
                      QStringLiteral("--tracker"), QStringLiteral("simulated"),
                      QStringLiteral("--patient"), QLatin1StringView{guest.patient}});
    }

    Result<void> startAll()
    {
        m_players.reserve(kSceneGuests.size() + 1);
        Result<void> started = startConsole();
        for (std::size_t i = 0; started && i < kSceneGuests.size(); ++i)
            started = startGuest(int(i) + 1, kSceneGuests[i]);
        return started
            .and_then([&] {
                return waitUntil(kScenePatience, "not all see each other", [&] {
                    // The last line of a slow program may be without a frame.
                    for (ScenePartner& player : m_players)
                        player.hasSeenAll = player.hasSeenAll || player.seesAll();
                    return std::ranges::all_of(m_players, &ScenePartner::hasSeenAll);
                });
            })
            .and_then([&] { return takePlaces(); });
    }

    /// Who is elsewhere chooses a place of their own among the others.
    Result<void> takePlaces()
    {
        for (std::size_t i = 0; i < kSceneGuests.size(); ++i)
            if (kSceneGuests[i].isRemote)
                m_players[i + 1].work(QStringLiteral("press atLeft"));
        return letPass(kSettled);
    }

    Result<void> watch()
    {
        m_from = sessionTimeOf(m_players.front().journal());
        return letPass(m_settings.watched).map([&] {
            m_until = sessionTimeOf(m_players.front().journal());
        });
    }

    Result<void> takePictures()
    {
        if (m_settings.folder.isEmpty())
            return {};
        const auto pictureOf = [&](const ScenePartner& player) {
            return QDir{m_settings.folder}.filePath(player.name.toLower() + QStringLiteral(".png"));
        };
        for (const ScenePartner& player : m_players) {
            QFile::remove(pictureOf(player));
            player.work(QStringLiteral("picture ") + QDir{}.absoluteFilePath(pictureOf(player)));
        }
        return waitUntil(kPicturePatience, "a picture was not taken", [&] {
            return std::ranges::all_of(m_players, [&](const ScenePartner& player) {
                return QFile::exists(pictureOf(player));
            });
        });
    }

    SceneFigures evaluate()
    {
        SceneFigures figures{.network = m_network->name()};
        std::vector<DrawnScene> drawn;
        for (std::size_t i = 0; i < m_players.size(); ++i) {
            ScenePartner& player = m_players[i];
            const QString station =
                lastLine(player.journal())[QStringLiteral("station")].toString();
            player.program.reset();
            drawn.push_back({.participant = int(i), // in the order in which they came in
                             .station = station,
                             .isRemote = i > 0 && kSceneGuests[i - 1].isRemote,
                             .hasTools = i > 0,
                             .frames = drawnFramesIn(player.journal())});
            const auto& frames = drawn.back().frames;
            const auto watched =
                std::distance(frames.lower_bound(m_from), frames.upper_bound(m_until));
            figures.players.push_back(
                {player.name, drawn.back(), double(watched) / (m_until - m_from)});
        }
        figures.compared = compareScenes(drawn, m_from, m_until,
                                         {.longestGap = kLongestFrameGap,
                                          .toHost = meanDelay(m_settings.scenario.forward),
                                          .fromHost = meanDelay(m_settings.scenario.backward)});
        return figures;
    }

    [[nodiscard]] QString codes() const { return m_folder.filePath(QStringLiteral("codes")); }

    const SceneSettings& m_settings;
    QTemporaryDir m_folder;
    std::uint16_t m_port = freeScenePort();
    QTimer m_wake;
    std::unique_ptr<SceneNetwork> m_network;
    std::vector<ScenePartner> m_players; ///< the console first; they end before the network
    double m_from = 0.0;
    double m_until = 0.0;
};

} // namespace

Result<SceneFigures> runScene(const SceneSettings& settings) { return SceneRun{settings}.run(); }

} // namespace carina::lab
