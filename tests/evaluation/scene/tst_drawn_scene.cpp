#include "engine/core/units.h"
#include "engine/geometry/rotation.h"
#include "evaluation/scene/drawn_scene.h"
#include "tests/support/test_class.h"

#include <QFile>
#include <QTemporaryDir>

#include <numbers>

namespace carina::drawn_scene_test
{
namespace
{

constexpr int kHeadOfAnna = 7;
constexpr double kSpeed = 0.1; ///< m/s, of Anna's objects along x
constexpr double kLate = 0.04; ///< seconds, of Ben's view of them
const SceneConditions kAtOnce{.longestGap = 0.3, .toHost = {}, .fromHost = {}};
constexpr double kTolerance = 1e-9;

constexpr double kApart = 0.2; ///< m, of Carl's objects from Anna's, along y

RigidTransform movedTo(double t, double speed, double y = 0.0)
{
    return {Quat::Identity(), Vec3{speed * t, y, 0.0}};
}

/// Somebody's head, hand and tube, the first with this number, as a program has them.
std::map<int, DrawnObject> thingsOf(int owner, int first, bool isOwn, const RigidTransform& X_AO)
{
    std::map<int, DrawnObject> objects;
    for (const ObjectKind kind : {ObjectKind::Head, ObjectKind::Hand, ObjectKind::Tube})
        objects[first++] = {owner, int(kind), isOwn, X_AO};
    return objects;
}

/// Anna, participant 1, with tools; and Ben, who watches from far away and has none.
std::vector<DrawnScene> annaAndBen(double speed = kSpeed)
{
    DrawnScene anna{.participant = 1, .station = QStringLiteral("A"), .hasTools = true};
    DrawnScene ben{.participant = 2, .station = QStringLiteral("A"), .isRemote = true};
    for (int frame = 0; frame < 20; ++frame) {
        const double t = 0.1 * frame;
        anna.frames[t] = thingsOf(1, kHeadOfAnna, true, movedTo(t, speed));
        ben.frames[t + 0.03] = thingsOf(1, kHeadOfAnna, false, movedTo(t + 0.03 - kLate, speed));
    }
    return {anna, ben};
}

/// With Carl, participant 3, whose objects go beside Anna's.
std::vector<DrawnScene> annaBenAndCarl(double apart = kApart)
{
    constexpr int kHeadOfCarl = 17;
    auto scenes = annaAndBen();
    DrawnScene carl{.participant = 3, .station = QStringLiteral("A"), .hasTools = true};
    for (const auto& [t, objects] : scenes[0].frames)
        carl.frames[t] = thingsOf(3, kHeadOfCarl, true, movedTo(t, kSpeed, apart));
    for (auto& [t, objects] : scenes[1].frames)
        objects.merge(thingsOf(3, kHeadOfCarl, false, movedTo(t - kLate, kSpeed, apart)));
    scenes.push_back(carl);
    return scenes;
}

} // namespace

class TestDrawnScene : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Late by 40 ms at 100 mm/s: 4 mm.
    void comparesAtOneSessionTime()
    {
        const auto compared = compareScenes(annaAndBen(), 0.0, 2.0, kAtOnce);
        QVERIFY(compared.near.distances.empty());
        QCOMPARE(compared.far.distances.size(), std::size_t{57}); // not after Anna's last frame
        for (const double distance : compared.far.distances)
            QVERIFY(std::abs(distance - kSpeed * kLate) < kTolerance);
        QVERIFY(quantileOf(compared.far.angles, 1.0) < kTolerance);
        QCOMPARE(compared.pairs, 3);
        QCOMPARE(compared.leastShare, 1.0);
        QCOMPARE(compared.ownerChanges, 0);
    }

    /// With no delay 4 mm are still explained, 2.75 mm by the tracker and a hand and 1.75 mm by
    /// what is between two frames 0.1 s apart; 8 mm are by nothing but 40 ms at 200 mm/s.
    void boundsByTheObjectsOwnSpeedAndDelay()
    {
        QCOMPARE(compareScenes(annaAndBen(), 0.0, 2.0, kAtOnce).far.beyond, std::size_t{0});
        const auto fast = annaAndBen(2.0 * kSpeed);
        const auto compared = compareScenes(fast, 0.0, 2.0, kAtOnce);
        QCOMPARE(compared.far.beyond, compared.far.distances.size());
        const SceneConditions longWay{.longestGap = 0.3,
                                      .toHost = std::chrono::milliseconds{40},
                                      .fromHost = std::chrono::milliseconds{40}};
        QCOMPARE(compareScenes(fast, 0.0, 2.0, longWay).far.beyond, std::size_t{0});
    }

    /// Which the bound of each comparison lets pass, because of what is between two frames.
    void anOffsetOfEverythingIsSeen_data()
    {
        QTest::addColumn<double>("offset_mm");
        QTest::addColumn<bool>("isSeen");
        QTest::newRow("none") << 0.0 << false;
        QTest::newRow("3 mm") << 3.0 << true;
    }
    void anOffsetOfEverythingIsSeen()
    {
        QFETCH(const double, offset_mm);
        QFETCH(const bool, isSeen);
        auto scenes = annaAndBen();
        scenes[1].isRemote = false;
        for (auto& [t, objects] : scenes[1].frames)
            objects = thingsOf(1, kHeadOfAnna, false, movedTo(t, kSpeed, 1e-3 * offset_mm));
        const auto compared = compareScenes(scenes, 0.0, 2.0, kAtOnce);
        QCOMPARE(compared.near.beyond, std::size_t{0});
        QCOMPARE(isWithin(compared.near, kBoundsOnTheSpot), !isSeen);
        QCOMPARE(isWithin(compared.near, kBoundsOfRemote), !isSeen);
        QVERIFY(!isWithin(compared.far, kBoundsOfRemote)); // there are none
    }

    /// Anna's and Carl's things are 20 cm apart; from 1 s on Ben has Anna's where Carl's are, with
    /// the names and numbers of before.
    void recognisesWhoseAnObjectIsByItsPath()
    {
        auto scenes = annaBenAndCarl();
        const auto right = compareScenes(scenes, 0.0, 2.0, kAtOnce);
        QCOMPARE(right.mistaken, std::size_t{0});
        QCOMPARE(right.recognisable, right.far.distances.size());
        for (auto& [t, objects] : scenes[1].frames)
            if (t > 1.0)
                objects[kHeadOfAnna].X_AO = movedTo(t - kLate, kSpeed, kApart);
        const auto swapped = compareScenes(scenes, 0.0, 2.0, kAtOnce);
        QCOMPARE(swapped.ownerChanges, 0);
        QCOMPARE(swapped.mistaken, std::size_t{9}); // frames from 1.03 s on; not after Anna's last
    }

    /// Where two people have theirs in one place, nobody can tell whose it is.
    void recognisesNobodyWhereTwoAreInOnePlace()
    {
        const auto compared = compareScenes(annaBenAndCarl(0.001), 0.0, 2.0, kAtOnce);
        QCOMPARE(compared.recognisable, std::size_t{0});
        QCOMPARE(compared.mistaken, std::size_t{0});
    }

    void doesNotGuessAcrossALongGap()
    {
        const auto compared = compareScenes(annaAndBen(), 0.0, 2.0, {.longestGap = 0.05});
        QVERIFY(compared.far.distances.empty());
    }

    void seesWhatIsNotDrawn()
    {
        auto scenes = annaAndBen();
        for (auto& [t, objects] : scenes[1].frames)
            if (t > 1.0)
                objects.erase(kHeadOfAnna);
        const auto compared = compareScenes(scenes, 0.0, 2.0, kAtOnce);
        QVERIFY(std::abs(compared.leastShare - 0.5) < 0.1);
        QCOMPARE(compared.leastDrawn.viewer, 2);
        QCOMPARE(compared.leastDrawn.owner, 1);
        QCOMPARE(int(compared.leastDrawn.kind), int(ObjectKind::Head));
    }

    /// Nor are they seen while Anna's program itself does not have them.
    void expectsNothingThatItsOwnerHasNot()
    {
        auto scenes = annaAndBen();
        for (auto& scene : scenes)
            for (auto& [t, objects] : scene.frames)
                if (t > 1.0)
                    objects.erase(kHeadOfAnna);
        QCOMPARE(compareScenes(scenes, 0.0, 2.0, kAtOnce).leastShare, 1.0);
    }

    void expectsNobodyFromAnotherStation()
    {
        auto scenes = annaAndBen();
        scenes[1].station = QStringLiteral("B");
        scenes[1].frames.clear();
        const auto compared = compareScenes(scenes, 0.0, 2.0, kAtOnce);
        QCOMPARE(compared.pairs, 0);
        QCOMPARE(compared.leastShare, 1.0);
    }

    /// Once there and once back.
    void countsEachChangeOfAnOwner()
    {
        auto scenes = annaAndBen();
        std::next(scenes[1].frames.begin(), 5)->second[kHeadOfAnna].owner = 3;
        QCOMPARE(compareScenes(scenes, 0.0, 2.0, kAtOnce).ownerChanges, 2);
    }

    void readsAJournal()
    {
        QTemporaryDir folder;
        QFile file{folder.filePath(QStringLiteral("journal.jsonl"))};
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(R"({"frames":[{"session_ns":1500000000,"objects":[{"object":7,"owner":1,)"
                   R"("kind":0,"own":true,"xyz_mm":[10,20,30],"q_xyzw":[0,0,1,0]}]}]})"
                   "\nno line\n");
        file.close();
        const DrawnFrames frames = drawnFramesIn(file.fileName());
        QCOMPARE(frames.size(), std::size_t{1});
        QCOMPARE(frames.begin()->first, 1.5);
        const DrawnObject& object = frames.begin()->second.at(kHeadOfAnna);
        QCOMPARE(object.owner, 1);
        QVERIFY(object.isOwn);
        QVERIFY((object.X_AO.translation() - Vec3{0.01, 0.02, 0.03}).norm() < kTolerance);
        QVERIFY(
            std::abs(angleBetween(object.X_AO.rotation(), Quat::Identity()).si - std::numbers::pi)
            < kTolerance);
    }
};

CARINA_TEST(TestDrawnScene)

} // namespace carina::drawn_scene_test

#include "tst_drawn_scene.moc"
