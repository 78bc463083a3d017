// What a session host costs while an instructor's ten objects go to five participants, 60 times a
// second over encrypted sockets on this machine, participants being processes of their own. Beside
// it, in turn, the least that any host can cost: as many packets of that size sent as they are.
// Prints one JSON object.

#include "engine/net/node/session_node.h"
#include "tests/engine/net/node/memory_store.h"

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QProcess>
#include <QThread>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <numbers>
#include <vector>

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

namespace
{

using namespace std::chrono_literals;

constexpr std::size_t kReceivers = 5;
constexpr int kStreams = 10;
constexpr int kRounds = 5;
constexpr auto kRound = 4s;
constexpr auto kPatience = 20s;
constexpr int kPacketsPerSecond = 60 * static_cast<int>(kReceivers);
constexpr std::size_t kPacketBytes = 445; ///< a datagram of ten poses, encrypted
const QString kReceive = QStringLiteral("receive");

/// How keys are derived from codes is not what is measured.
carina::Result<carina::AccessKey> keyAtOnce(const carina::JoinCode& /*code*/,
                                            const carina::SessionKey& /*session*/)
{
    return carina::AccessKey{};
}

double secondsOf(clockid_t clock)
{
    timespec used{};
    clock_gettime(clock, &used);
    return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

/// An object on its way at any time.
carina::PoseSource poseSource(const carina::SessionNode& node, int index)
{
    return [&node, index] {
        carina::PoseSample sample;
        sample.time = node.now().value();
        const double t = carina::toSeconds(sample.time.time_since_epoch());
        sample.X_FO = {carina::Quat{Eigen::AngleAxisd{std::sin(t), carina::Vec3::UnitZ()}},
                       carina::Vec3{0.1 * index, std::sin(t), 0.0}};
        sample.motion = carina::Motion{.v_FO = carina::Vec3{0.0, std::cos(t), 0.0},
                                       .w_FO = std::cos(t) * carina::Vec3::UnitZ()};
        return std::optional{sample};
    };
}

/// A program that takes part until it is ended.
int receive(const QStringList& words)
{
    const auto code = carina::JoinCode::parse(words.at(3).toStdString());
    if (!code)
        return EXIT_FAILURE;
    const auto node = carina::SessionNode::join({.port = words.at(2).toUShort(),
                                                 .participantName = words.at(4).toStdString(),
                                                 .role = carina::Role::Trainee,
                                                 .station = {},
                                                 .code = *code,
                                                 .derive = keyAtOnce});
    return node ? QCoreApplication::exec() : EXIT_FAILURE;
}

/// Programs that end with this object.
class Receivers
{
public:
    Receivers(std::uint16_t port, const carina::JoinCode& code)
    {
        for (std::size_t i = 0; i < kReceivers; ++i)
            m_programs[i].start(QCoreApplication::applicationFilePath(),
                                {kReceive, QString::number(port),
                                 QString::fromStdString(code.text()),
                                 QStringLiteral("receiver %1").arg(i)});
    }
    ~Receivers()
    {
        for (QProcess& program : m_programs) {
            program.kill();
            program.waitForFinished();
        }
    }
    Receivers(const Receivers&) = delete;
    Receivers& operator=(const Receivers&) = delete;

private:
    std::array<QProcess, kReceivers> m_programs;
};

bool areAllIn(const carina::SessionNode& host)
{
    return host.links().size() == kReceivers
           && host.state()->objects().size() == static_cast<std::size_t>(kStreams);
}

/// Percent of one core that the whole process uses.
double hostRound()
{
    const double before = secondsOf(CLOCK_PROCESS_CPUTIME_ID);
    QThread::sleep(kRound.count());
    return 100.0 * (secondsOf(CLOCK_PROCESS_CPUTIME_ID) - before) / double(kRound.count());
}

/// Percent of one core that it takes to send one second's packets, and nothing else.
double sendingRound()
{
    const int from = socket(AF_INET, SOCK_DGRAM, 0);
    const int to = socket(AF_INET, SOCK_DGRAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t length = sizeof address;
    auto* anyAddress = reinterpret_cast<sockaddr*>(&address);
    bind(to, anyAddress, length);
    getsockname(to, anyAddress, &length);
    const std::array<std::byte, kPacketBytes> packet{};
    const double before = secondsOf(CLOCK_THREAD_CPUTIME_ID);
    for (int i = 0; i < kPacketsPerSecond; ++i)
        sendto(from, packet.data(), packet.size(), 0, anyAddress, length);
    const double used = secondsOf(CLOCK_THREAD_CPUTIME_ID) - before;
    close(from);
    close(to);
    return 100.0 * used;
}

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

int measure()
{
    carina::MemoryDisk disk;
    const auto host = carina::SessionNode::host(
        {.sessionName = "Course", .participantName = "Dr Hall", .derive = keyAtOnce},
        std::make_unique<carina::MemoryStore>(disk));
    if (!host)
        return EXIT_FAILURE;
    for (int i = 0; i < kStreams; ++i)
        (*host)->publish(carina::ObjectKind::Tube, "object " + std::to_string(i),
                         poseSource(**host, i));
    const Receivers receivers{(*host)->port(), (*host)->joinCodes().at(carina::Role::Trainee)};
    for (const QDeadlineTimer patience{kPatience}; !areAllIn(**host);) {
        if (patience.hasExpired()) {
            std::fputs("Not all participants came.\n", stderr);
            return EXIT_FAILURE;
        }
        QThread::msleep(50);
    }
    std::vector<double> hosting;
    std::vector<double> sending;
    for (int i = 0; i < kRounds; ++i) {
        hosting.push_back(hostRound());
        sending.push_back(sendingRound());
    }
    const double ours = median(hosting);
    const double peer = median(sending);
    std::printf("{\n  \"schema\": \"carina.bench.host/1\",\n  \"participants\": %zu,\n"
                "  \"streams\": %d,\n  \"rounds\": %d,\n  \"host_median_percent\": %.2f,\n"
                "  \"bare_sending_median_percent\": %.2f,\n  \"ratio_to_bare_sending\": %.1f\n}\n",
                kReceivers, kStreams, kRounds, ours, peer, ours / peer);
    return areAllIn(**host) ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace

int main(int argc, char** argv)
{
    const QCoreApplication application{argc, argv};
    const QStringList words = QCoreApplication::arguments();
    return words.size() == 5 && words.at(1) == kReceive ? receive(words) : measure();
}
