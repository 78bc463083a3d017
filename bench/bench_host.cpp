// What a session host costs, over encrypted sockets on this machine, participants being processes
// of their own. Prints one JSON object:
//
// - while an instructor's ten objects go to five participants, 60 times a second. Beside it, in
//   turn, the least that any host can cost: as many packets of that size sent as they are;
// - "course": five stations, at each of which a participant sends six tracked objects, which go to
//   all others there;
// - "growth": the same with fewer participants, objects or both.

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
#include <memory>
#include <optional>
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
constexpr auto kPatience = 60s;
constexpr int kPacketsPerSecond = 60 * static_cast<int>(kReceivers);
constexpr std::size_t kPacketBytes = 445; ///< a datagram of ten poses, encrypted
/// Of a participant who sends: head and hands, a tube, a stylus, the manikin's head and jaw.
constexpr int kOwnObjects = 6;
/// A trainee may have two of a kind.
constexpr std::array kKinds{carina::ObjectKind::Head, carina::ObjectKind::Jaw,
                            carina::ObjectKind::Tube, carina::ObjectKind::Stylus};
const QString kTakePart = QStringLiteral("take-part");

constexpr int kStations = 5;
/// Who takes part beside the host, and how many of them send kOwnObjects each.
struct Course {
    int participants = 0;
    int senders = 0;
    int stations = kStations; ///< of those that are open
};
constexpr Course kCourse{16, kStations};
constexpr std::array kGrowth{Course{4, 1},  Course{16, 1}, Course{4, 2},
                             Course{16, 2}, Course{8, 5},  Course{16, 10}};

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

void publishObjects(carina::SessionNode& node, int count)
{
    for (int i = 0; i < count; ++i)
        node.publish(kKinds[std::size_t(i) % kKinds.size()], "object " + std::to_string(i),
                     poseSource(node, i));
}

/// A program that takes part until it is ended: take-part PORT CODE NAME STATION OBJECTS
int takePart(const QStringList& words)
{
    const auto code = carina::JoinCode::parse(words.at(3).toStdString());
    if (!code)
        return EXIT_FAILURE;
    const auto node = carina::SessionNode::join({.port = words.at(2).toUShort(),
                                                 .participantName = words.at(4).toStdString(),
                                                 .role = carina::Role::Trainee,
                                                 .station = words.at(5).toStdString(),
                                                 .code = *code,
                                                 .derive = keyAtOnce});
    if (!node)
        return EXIT_FAILURE;
    for (const QDeadlineTimer patience{kPatience}; !(*node)->now();) {
        if (patience.hasExpired())
            return EXIT_FAILURE;
        QThread::msleep(10);
    }
    publishObjects(**node, words.at(6).toInt());
    return QCoreApplication::exec();
}

/// The first station of a session has the first of these names.
QString stationName(int index) { return QStringLiteral("Station %1").arg(index + 1); }

/// Programs that end with this object.
class Participants
{
public:
    Participants(const carina::SessionNode& host, const Course& course)
    {
        const auto code = host.joinCodes().at(carina::Role::Trainee);
        for (int i = 0; i < course.participants; ++i) {
            m_programs.push_back(std::make_unique<QProcess>());
            m_programs.back()->start(
                QCoreApplication::applicationFilePath(),
                {kTakePart, QString::number(host.port()), QString::fromStdString(code.text()),
                 QStringLiteral("participant %1").arg(i), stationName(i % course.stations),
                 QString::number(i < course.senders ? kOwnObjects : 0)});
        }
    }
    ~Participants()
    {
        for (const auto& program : m_programs)
            program->kill();
        for (const auto& program : m_programs)
            program->waitForFinished();
    }
    Participants(const Participants&) = delete;
    Participants& operator=(const Participants&) = delete;

private:
    std::vector<std::unique_ptr<QProcess>> m_programs;
};

/// Opens the other stations.
bool openStations(carina::SessionNode& host)
{
    for (int i = 1; i < kStations; ++i)
        host.propose(carina::kNoStation, carina::fact::StationAdded{stationName(i).toStdString()});
    for (const QDeadlineTimer patience{kPatience}; host.state()->stations().size() < kStations;) {
        if (patience.hasExpired())
            return false;
        QThread::msleep(10);
    }
    return true;
}

std::unique_ptr<carina::SessionNode> hostedOn(carina::MemoryDisk& disk)
{
    auto host = carina::SessionNode::host(
        {.sessionName = "Course", .participantName = "Dr Hall", .derive = keyAtOnce},
        std::make_unique<carina::MemoryStore>(disk));
    return host && openStations(**host) ? *std::move(host) : nullptr;
}

bool areAllIn(const carina::SessionNode& host, std::size_t participants, int objects)
{
    return host.links().size() == participants
           && host.state()->objects().size() == static_cast<std::size_t>(objects);
}

bool waitForAll(const carina::SessionNode& host, std::size_t participants, int objects)
{
    for (const QDeadlineTimer patience{kPatience}; !areAllIn(host, participants, objects);) {
        if (patience.hasExpired()) {
            std::fputs("Not all participants came.\n", stderr);
            return false;
        }
        QThread::msleep(50);
    }
    return true;
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

/// The host alone, in percent of one core; nothing where not all came, or stayed.
std::optional<double> courseCost(const Course& course, int rounds)
{
    carina::MemoryDisk disk;
    const auto host = hostedOn(disk);
    const int objects = course.senders * kOwnObjects;
    if (!host)
        return std::nullopt;
    const Participants participants{*host, course};
    if (!waitForAll(*host, std::size_t(course.participants), objects))
        return std::nullopt;
    std::vector<double> hosting;
    for (int i = 0; i < rounds; ++i)
        hosting.push_back(hostRound());
    const bool isWhole = areAllIn(*host, std::size_t(course.participants), objects);
    return isWhole ? std::optional{median(hosting)} : std::nullopt;
}

bool printCourse(const Course& course, int rounds)
{
    const auto cost = courseCost(course, rounds);
    if (cost)
        std::printf("{\"participants\": %d, \"objects\": %d, \"host_median_percent\": %.2f}",
                    course.participants, course.senders * kOwnObjects, *cost);
    return cost.has_value();
}

bool printInstructor()
{
    carina::MemoryDisk disk;
    const auto host = hostedOn(disk);
    if (!host)
        return false;
    publishObjects(*host, kStreams);
    const Participants receivers{*host, {kReceivers, 0, 1}};
    if (!waitForAll(*host, kReceivers, kStreams))
        return false;
    std::vector<double> hosting;
    std::vector<double> sending;
    for (int i = 0; i < kRounds; ++i) {
        hosting.push_back(hostRound());
        sending.push_back(sendingRound());
    }
    const double ours = median(hosting);
    const double peer = median(sending);
    std::printf("  \"participants\": %zu,\n  \"streams\": %d,\n  \"rounds\": %d,\n"
                "  \"host_median_percent\": %.2f,\n  \"bare_sending_median_percent\": %.2f,\n"
                "  \"ratio_to_bare_sending\": %.1f,\n",
                kReceivers, kStreams, kRounds, ours, peer, ours / peer);
    return areAllIn(*host, kReceivers, kStreams);
}

int measure()
{
    std::printf("{\n  \"schema\": \"carina.bench.host/1\",\n");
    if (!printInstructor())
        return EXIT_FAILURE;
    std::printf("  \"course\": ");
    if (!printCourse(kCourse, kRounds))
        return EXIT_FAILURE;
    std::printf(",\n  \"growth\": [");
    for (const Course& course : kGrowth) {
        std::printf("%s\n    ", &course == kGrowth.data() ? "" : ",");
        if (!printCourse(course, 1))
            return EXIT_FAILURE;
    }
    std::printf("\n  ]\n}\n");
    return EXIT_SUCCESS;
}

} // namespace

int main(int argc, char** argv)
{
    const QCoreApplication application{argc, argv};
    const QStringList words = QCoreApplication::arguments();
    return words.size() == 7 && words.at(1) == kTakePart ? takePart(words) : measure();
}
