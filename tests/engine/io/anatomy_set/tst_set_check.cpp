#include "engine/io/anatomy_set/set_check.h"

#include "tests/engine/io/anatomy_set/carried_set_files.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <limits>

namespace carina::set_check_test
{

class TestSetCheck : public QObject
{
    Q_OBJECT

private:
    using Spoil = std::function<void(Anatomy&)>;

    static bool passes(const Spoil& spoil)
    {
        ImportedSet set = test::carriedSample();
        spoil(set.anatomy);
        const auto checked = checkSet(set);
        Q_ASSERT(checked || checked.error().code == Errc::FileMalformed);
        return checked.has_value();
    }
    static TriangleMesh& meshOf(Anatomy& anatomy) { return anatomy.parts[0].levels[0]; }

private Q_SLOTS:
    void takesWhatAnImportMakes()
    {
        QVERIFY(passes([](Anatomy&) {}));
        QVERIFY(passes([](Anatomy& a) { a.parts.clear(); }));
        QVERIFY(passes([](Anatomy& a) { a.landmarks.path_A.clear(); })); // without a trachea
    }

    void refusesASurfaceThatCannotBeDrawn()
    {
        const float nan = std::numeric_limits<float>::quiet_NaN();
        const float inf = std::numeric_limits<float>::infinity();
        QVERIFY(!passes([](Anatomy& a) { meshOf(a) = {}; }));
        QVERIFY(!passes([](Anatomy& a) { meshOf(a).normals.clear(); }));
        QVERIFY(!passes([](Anatomy& a) { meshOf(a).normals.pop_back(); }));
        QVERIFY(!passes([=](Anatomy& a) { meshOf(a).positions[2].y() = nan; }));
        QVERIFY(!passes([=](Anatomy& a) { meshOf(a).positions[2].y() = inf; }));
        QVERIFY(!passes([=](Anatomy& a) { meshOf(a).normals[3].z() = nan; }));
        QVERIFY(!passes([=](Anatomy& a) { // of any level
            a.parts[0].levels.push_back(meshOf(a));
            a.parts[0].levels[1].positions[0].x() = nan;
        }));
    }

    void refusesWhatLiesFartherThanTenMetresAway()
    {
        QVERIFY(passes([](Anatomy& a) { meshOf(a).positions[0].z() = -10.0F; }));
        QVERIFY(!passes([](Anatomy& a) { meshOf(a).positions[0].z() = -10.001F; }));
        QVERIFY(passes([](Anatomy& a) { a.landmarks.p_A_glottis.x() = 10.0; }));
        QVERIFY(!passes([](Anatomy& a) { a.landmarks.p_A_glottis.x() = 10.001; }));
        QVERIFY(!passes([](Anatomy& a) { a.landmarks.p_A_incisors.x() = std::nan(""); }));
        QVERIFY(!passes([](Anatomy& a) { a.landmarks.p_A_carina.y() = -11.0; }));
    }

    void refusesAnAirwayThatDoesNotGoOn()
    {
        const auto path = [](std::vector<Vec3> points) {
            return passes([&](Anatomy& a) { a.landmarks.path_A = points; });
        };
        QVERIFY(path({{0, 0, 0}, {0, 0, 0.0999}, {0, 0.001, 0.1}}));
        QVERIFY(!path({{0, 0, 0}, {0, 0, 0}}));                     // stays
        QVERIFY(!path({{0, 0, 0}, {0, 0, 1e-7}}));                  // all but stays
        QVERIFY(!path({{0, 0, 0}, {0, 0, 0.1001}}));                // leaps
        QVERIFY(!path({{0, 0, 0}, {0, 0, 0.01}, {0, 0, 0.005}}));   // turns back
        QVERIFY(!path({{0, 0, 0}, {0, 0, 0.01}, {0, 0.01, 0.01}})); // turns square
        QVERIFY(path({{0, 0, 0}, {0, 0, 0.01}, {0, 0.01, 0.0101}}));
        QVERIFY(!path({{0, 0, 0}, {0, 0, std::nan("")}}));
    }

    void refusesAnAirwayOfTooManyPoints()
    {
        const auto straight = [](int points) {
            return [points](Anatomy& a) {
                a.landmarks.path_A.clear();
                for (int i = 0; i < points; ++i)
                    a.landmarks.path_A.emplace_back(0.0, 0.0, 1e-3 * i);
            };
        };
        QVERIFY(passes(straight(4096)));
        QVERIFY(!passes(straight(4097)));
    }
};

CARINA_TEST(TestSetCheck)

} // namespace carina::set_check_test

#include "tst_set_check.moc"
