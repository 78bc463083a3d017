#include "engine/core/units.h"
#include "engine/geometry/vec.h"
#include "tests/end_to_end/program.h"
#include "tests/support/test_class.h"

#include <QJsonArray>
#include <QTemporaryDir>

#include <cmath>
#include <map>
#include <optional>
#include <ranges>

namespace carina::lifting_test
{

namespace
{

constexpr int kFrames = 20;               ///< of both, in motion, that are compared
constexpr double kTurn_deg_per_s = 100.0; ///< of the airway, about z
constexpr double kMove_mm_per_s = 20.0;   ///< of the lungs, along x
constexpr double kTolerance_deg = 0.01;   ///< clocks of 0.1 ms
constexpr double kTolerance_mm = 0.002;   ///< likewise
constexpr double kClearly_deg = 5.0;      ///< more than this: it has begun
constexpr double kClearly_mm = 2.0;       ///< likewise
constexpr int kConsole = 0;               ///< the participants' numbers
constexpr int kTrainee = 1;

/// A group that is drawn lifted out.
struct Lifted {
    int owner = -1;
    Vec3 p_mm = Vec3::Zero();
    double turned_deg = 0.0; ///< about z
};

/// Those in a frame, by name of the group.
using Groups = std::map<QString, Lifted>;

Groups groupsIn(const QJsonObject& frame)
{
    Groups groups;
    for (const QJsonValue& each : frame[QStringLiteral("lifted")].toArray()) {
        const QJsonArray p = each[QStringLiteral("xyz_mm")].toArray();
        const QJsonArray q = each[QStringLiteral("q_xyzw")].toArray();
        groups[each[QStringLiteral("group")].toString()] = {
            each[QStringLiteral("owner")].toInt(),
            {p[0].toDouble(), p[1].toDouble(), p[2].toDouble()},
            inDegrees(radians(2.0 * std::atan2(q[2].toDouble(), q[3].toDouble())))};
    }
    return groups;
}

double secondsOf(const QJsonObject& frame)
{
    return 1e-9 * double(frame[QStringLiteral("session_ns")].toInteger());
}

/// The last frame a program drew: on a busy computer a line of its journal may have none.
QJsonObject lastFrame(const Program& program)
{
    const std::vector<QJsonObject> lines = program.allShown();
    for (const QJsonObject& line : std::views::reverse(lines))
        if (const QJsonArray frames = line[QStringLiteral("frames")].toArray(); !frames.isEmpty())
            return frames.last().toObject();
    return {};
}

/// All frames of a journal in which both groups are lifted out, by session time in seconds.
std::map<double, Groups> framesIn(const QString& journal)
{
    std::map<double, Groups> frames;
    QFile file{journal};
    if (!file.open(QIODevice::ReadOnly))
        return frames;
    for (const QByteArray& line : file.readAll().split('\n'))
        for (const QJsonValue& frame :
             QJsonDocument::fromJson(line).object()[QStringLiteral("frames")].toArray())
            if (Groups groups = groupsIn(frame.toObject()); groups.size() == 2)
                frames[secondsOf(frame.toObject())] = std::move(groups);
    return frames;
}

double between_deg(double a, double b) { return std::abs(std::remainder(b - a, 360.0)); }

const QString kAirway = QStringLiteral("airway");
const QString kLungs = QStringLiteral("lungs");

} // namespace

/// The console lifts the airway out and a trainee the lungs, both by scripts that work the controls
/// a person would use; both programs write what they draw.
class TestLifting : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        const QString codes = m_folder.filePath(QStringLiteral("codes"));
        const QStringList common{QStringLiteral("--port"),    portOfThisTest(),
                                 QStringLiteral("--patient"), QStringLiteral("child"),
                                 QStringLiteral("--data"),    m_folder.path()};
        const auto seat = [&](const char* name, const QString& path, const QStringList& more) {
            Seat made;
            made.journal = file(name) + QStringLiteral(".jsonl");
            made.script = std::make_unique<QFile>(file(name) + QStringLiteral(".script"));
            made.program = std::make_unique<Program>(
                path,
                common + more + QStringList{QStringLiteral("--script"), made.script->fileName()},
                made.journal);
            return made;
        };
        m_console = seat("instructor", QStringLiteral(CARINA_INSTRUCTOR),
                         {QStringLiteral("--codes"), codes, QStringLiteral("--start")});
        m_trainee = seat(
            "trainee", QStringLiteral(CARINA_TRAINEE),
            {QStringLiteral("--as"), QStringLiteral("Tom"), QStringLiteral("--code-file"), codes});
        for (Seat* each : {&m_console, &m_trainee}) {
            QVERIFY(each->script->open(QIODevice::WriteOnly));
            each->program->start();
            QTRY_VERIFY_WITH_TIMEOUT(!each->program->shown().isEmpty(), kPatience_ms);
        }
        m_console.work({"choose object Airway", "press lift"});
        m_trainee.work({"choose object Lungs", "press lift"});
        QTRY_VERIFY_WITH_TIMEOUT(bothDrawBoth(), kPatience_ms);
        m_inPlace = m_console.drawn();
    }

    void eachHasWhatItLifted()
    {
        for (const Seat* seat : {&m_console, &m_trainee}) {
            QCOMPARE(seat->drawn()[kAirway].owner, kConsole);
            QCOMPARE(seat->drawn()[kLungs].owner, kTrainee);
        }
        QVERIFY(isSame(m_console.drawn(), m_trainee.drawn()));
    }

    /// Both at once, each its own: each frame of the trainee's program against the console's frame
    /// that is nearest to it, by how far the groups go in the time between the two.
    void bothDrawBothMotionsAlike()
    {
        m_console.work({"type speed 100", "press begin"});
        m_trainee.work({"choose kind Move along", "choose axis x, to the left", "type speed 20",
                        "press begin"});
        QTRY_VERIFY_WITH_TIMEOUT(hasBegun(m_console) && hasBegun(m_trainee), kPatience_ms);
        const double from = std::max(m_console.time(), m_trainee.time());
        const auto isSeen = [from](const Seat& seat) {
            const auto frames = framesIn(seat.journal);
            return std::distance(frames.upper_bound(from), frames.end()) >= kFrames;
        };
        QTRY_VERIFY_WITH_TIMEOUT(isSeen(m_console) && isSeen(m_trainee), kPatience_ms);
        const double until = std::min(m_console.time(), m_trainee.time());
        m_console.work({"press stop"});
        m_trainee.work({"press stop"});
        const auto ours = framesIn(m_console.journal);
        const auto theirs = framesIn(m_trainee.journal);
        int compared = 0;
        for (auto frame = theirs.upper_bound(from); frame != theirs.upper_bound(until); ++frame) {
            const auto other = ours.lower_bound(frame->first);
            if (other == ours.end() || other->first > until)
                continue;
            const double dt = other->first - frame->first;
            const Groups& a = frame->second;
            const Groups& b = other->second;
            QVERIFY(between_deg(a.at(kAirway).turned_deg + kTurn_deg_per_s * dt,
                                b.at(kAirway).turned_deg)
                    < kTolerance_deg);
            const Vec3 moved = a.at(kLungs).p_mm + Vec3{kMove_mm_per_s * dt, 0.0, 0.0};
            QVERIFY((moved - b.at(kLungs).p_mm).norm() < kTolerance_mm);
            ++compared;
        }
        QVERIFY2(compared >= kFrames / 2, qPrintable(QString::number(compared)));
    }

    void bothRestAlike()
    {
        // Frames of two programs are never of one moment: in motion they differ.
        QTRY_VERIFY_WITH_TIMEOUT(isSame(m_console.drawn(), m_trainee.drawn()), kPatience_ms);
        QVERIFY((m_console.drawn()[kLungs].p_mm - m_inPlace[kLungs].p_mm).norm() > kClearly_mm);
    }

    /// The trainee's step alone.
    void undoIsSeenByBoth()
    {
        const Groups before = m_console.drawn();
        m_trainee.work({"press undoAction"});
        const auto isUndone = [this](const Seat& seat) {
            return (seat.drawn()[kLungs].p_mm - m_inPlace[kLungs].p_mm).norm() < kTolerance_mm;
        };
        QTRY_VERIFY_WITH_TIMEOUT(isUndone(m_console) && isUndone(m_trainee), kPatience_ms);
        QVERIFY(isSame(m_console.drawn()[kAirway], before.at(kAirway)));
        QVERIFY(isSame(m_trainee.drawn()[kAirway], before.at(kAirway)));
    }

    void theInstructorPutsEverythingBack()
    {
        m_console.work({"press putAllBack"});
        QTRY_VERIFY_WITH_TIMEOUT(m_console.hasNothingOut() && m_trainee.hasNothingOut(),
                                 kPatience_ms);
    }

    /// And what is lifted again begins in its place.
    void whatATraineeHeldGoesBackWhenTheyAreGone()
    {
        m_trainee.work({"press lift"});
        const auto holdsLungs = [this] {
            return m_console.holders() == QJsonObject{{kLungs, kTrainee}}
                   && m_console.drawn().contains(kLungs);
        };
        QTRY_VERIFY_WITH_TIMEOUT(holdsLungs(), kPatience_ms);
        QVERIFY(isSame(m_console.drawn()[kLungs], m_inPlace[kLungs]));
        m_trainee.program->kill();
        QTRY_VERIFY_WITH_TIMEOUT(m_console.hasNothingOut(), kPatience_ms);
    }

private:
    /// A program with its script.
    struct Seat {
        QString journal;
        std::unique_ptr<QFile> script;
        std::unique_ptr<Program> program;

        /// Appends lines to the script.
        void work(std::initializer_list<const char*> lines) const
        {
            for (const char* line : lines)
                script->write(QByteArray{line} + '\n');
            QVERIFY(script->flush());
        }
        [[nodiscard]] Groups drawn() const { return groupsIn(lastFrame(*program)); }
        [[nodiscard]] double time() const { return secondsOf(lastFrame(*program)); }
        [[nodiscard]] QJsonObject holders() const
        {
            return program->shown()[QStringLiteral("holders")].toObject();
        }
        [[nodiscard]] bool hasNothingOut() const
        {
            const QJsonObject frame = lastFrame(*program);
            return !frame.isEmpty() && groupsIn(frame).empty() && holders().isEmpty();
        }
    };

    [[nodiscard]] QString file(const char* name) const
    {
        return m_folder.filePath(QString::fromLatin1(name));
    }
    [[nodiscard]] bool bothDrawBoth() const
    {
        return m_console.drawn().size() == 2 && m_trainee.drawn().size() == 2;
    }
    static bool isSame(const Lifted& a, const Lifted& b)
    {
        return (a.p_mm - b.p_mm).norm() < kTolerance_mm
               && between_deg(a.turned_deg, b.turned_deg) < kTolerance_deg;
    }
    static bool isSame(const Groups& a, const Groups& b)
    {
        return a.size() == 2 && b.size() == 2 && isSame(a.at(kAirway), b.at(kAirway))
               && isSame(a.at(kLungs), b.at(kLungs));
    }
    /// Whether a program draws both groups away from their places.
    [[nodiscard]] bool hasBegun(const Seat& seat) const
    {
        Groups now = seat.drawn();
        return now.size() == 2
               && between_deg(now[kAirway].turned_deg, m_inPlace.at(kAirway).turned_deg)
                      > kClearly_deg
               && (now[kLungs].p_mm - m_inPlace.at(kLungs).p_mm).norm() > kClearly_mm;
    }
    QTemporaryDir m_folder;
    Seat m_console;
    Seat m_trainee;
    Groups m_inPlace;
};

CARINA_TEST(TestLifting)

} // namespace carina::lifting_test

#include "tst_lifting.moc"
