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
constexpr double kGap = 0.3;   ///< seconds
constexpr double kTolerance = 1e-9;

RigidTransform movedTo(double t) { return {Quat::Identity(), Vec3{kSpeed * t, 0.0, 0.0}}; }

/// Anna's head, hand and tube, 7 to 9, as a program has them that is late by so much.
std::map<int, DrawnObject> annas(double t, bool isOwn)
{
    std::map<int, DrawnObject> objects;
    int id = kHeadOfAnna;
    for (const ObjectKind kind : {ObjectKind::Head, ObjectKind::Hand, ObjectKind::Tube})
        objects[id++] = {1, int(kind), isOwn, movedTo(t)};
    return objects;
}

/// Anna, participant 1, with tools; and Ben, who watches from far away and has none.
std::vector<DrawnScene> annaAndBen()
{
    DrawnScene anna{.participant = 1, .station = QStringLiteral("A"), .hasTools = true};
    DrawnScene ben{.participant = 2, .station = QStringLiteral("A"), .isRemote = true};
    for (double t = 0.0; t < 2.0; t += 0.1) {
        anna.frames[t] = annas(t, true);
        ben.frames[t + 0.03] = annas(t + 0.03 - kLate, false);
    }
    return {anna, ben};
}

} // namespace

class TestDrawnScene : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Late by 40 ms at 100 mm/s: 4 mm.
    void comparesAtOneSessionTime()
    {
        const auto compared = compareScenes(annaAndBen(), 0.0, 2.0, kGap);
        QVERIFY(compared.near.distances.empty());
        QCOMPARE(compared.far.distances.size(), std::size_t{57}); // not after Anna's last frame
        for (const double distance : compared.far.distances)
            QVERIFY(std::abs(distance - kSpeed * kLate) < kTolerance);
        QVERIFY(quantileOf(compared.far.angles, 1.0) < kTolerance);
        QCOMPARE(compared.pairs, 3);
        QCOMPARE(compared.leastShare, 1.0);
        QCOMPARE(compared.ownerChanges, 0);
    }

    void doesNotGuessAcrossALongGap()
    {
        const auto compared = compareScenes(annaAndBen(), 0.0, 2.0, 0.05);
        QVERIFY(compared.far.distances.empty());
    }

    void seesWhatIsNotDrawn()
    {
        auto scenes = annaAndBen();
        for (auto& [t, objects] : scenes[1].frames)
            if (t > 1.0)
                objects.erase(kHeadOfAnna);
        const auto compared = compareScenes(scenes, 0.0, 2.0, kGap);
        QVERIFY(std::abs(compared.leastShare - 0.5) < 0.1);
        QCOMPARE(compared.leastDrawn.viewer, 2);
        QCOMPARE(compared.leastDrawn.owner, 1);
        QCOMPARE(int(compared.leastDrawn.kind), int(ObjectKind::Head));
    }

    void expectsNobodyFromAnotherStation()
    {
        auto scenes = annaAndBen();
        scenes[1].station = QStringLiteral("B");
        scenes[1].frames.clear();
        const auto compared = compareScenes(scenes, 0.0, 2.0, kGap);
        QCOMPARE(compared.pairs, 0);
        QCOMPARE(compared.leastShare, 1.0);
    }

    /// Once there and once back.
    void countsEachChangeOfAnOwner()
    {
        auto scenes = annaAndBen();
        std::next(scenes[1].frames.begin(), 5)->second[kHeadOfAnna].owner = 3;
        QCOMPARE(compareScenes(scenes, 0.0, 2.0, kGap).ownerChanges, 2);
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
