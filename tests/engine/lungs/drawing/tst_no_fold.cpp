#include "engine/lungs/drawing/chest_pose.h"
#include "tests/engine/lungs/drawing/interval.h"
#include "tests/support/test_class.h"

namespace carina::no_fold_test
{

using test::Interval;

namespace
{

constexpr double kLeastDeterminant = 0.1;
constexpr double kSmallest = 0.002; ///< cell, in shares of the chest: the proof has failed there
/// Shares of the range that collapse and shift into the lung may take, in as many pieces.
constexpr int kPieces = 16;
/// The piece of what lies below the lungs: diaphragm and wall, which do not collapse.
constexpr int kBelow = -1;

/// u, v and h of the left hilum: where it is taken to be in boxes around landmarks, and where the
/// built-in patients and the set of a real man have it.
const std::array<Vec3, 2> kHila{Vec3{0.3, 0.55, 0.45}, Vec3{0.25, 0.66, 0.25}};

using Terms = ChestCoefficients<Interval>;
using Place = Shares<Interval>;

Shares<Interval> exactly(const Shares<double>& s) { return {s.u, s.v, s.h}; }

ChestFrame<Interval> exactly(const ChestFrame<double>& frame)
{
    return {exactly(frame.origin), exactly(frame.perMetre), exactly(frame.rightHilum),
            exactly(frame.leftHilum), frame.frontShare};
}

/// The corners of the poses of a right lung in one piece of the range. det (I + grad f) is linear
/// in each row of the matrix, and each row in the pose: so it is least where every row is at a
/// corner of its own, even though not all of these go together.
struct Corners {
    std::vector<Terms> u;
    std::vector<Terms> v;
    std::vector<Terms> h;
};

Terms termsOf(const LungPose& lung, double shift, const Interval& shrink, const ChestField& field)
{
    const ChestTerms<double> c =
        motionOf(ChestRegion::RightLowerLung, {{lung, {}}, shift}, field).right;
    const ChestTerms<Interval> terms{c.descent,  c.forward,  c.flare, c.lift,
                                     c.bulkBack, c.bulkDown, shrink,  c.shift};
    return {terms, terms};
}

Corners cornersOf(int piece, const ChestField& field)
{
    const double rest = 1.0 - double(std::max(piece, 0)) / kPieces; // for breath and gravity
    const double most = double(piece + 1) / kPieces;
    const Interval shrink{kMostCollapse * (1.0 - rest), kMostCollapse * most};
    const Interval swell{kLeastCollapse * most, kLeastCollapse * (1.0 - rest)};
    const std::array collapses{shrink, swell, Interval{0.0}};
    const std::array breaths{rest * kLeastBreath, rest * kGreatestBreath};
    const std::array descents{rest * kLeastBreath, rest * kMostDescent};
    Corners corners;
    for (const double ribs : breaths) {
        for (const double diaphragm : descents) {
            const LungPose breath{diaphragm, ribs, 0.0, 0.0};
            for (const Interval& collapse : collapses) {
                for (const double away : {0.0, kMostShift})
                    corners.u.push_back(termsOf(breath, away, collapse, field));
                for (const double gravity : {-rest * kMostGravity, rest * kMostGravity})
                    corners.v.push_back(
                        termsOf({diaphragm, ribs, gravity, 0.0}, 0.0, collapse, field));
            }
            corners.u.push_back(termsOf(breath, -kMostShift * most, Interval{0.0}, field));
        }
    }
    for (const double diaphragm : descents)
        for (const Interval& collapse : collapses)
            corners.h.push_back(termsOf({.diaphragm = diaphragm}, 0.0, collapse, field));
    return corners;
}

/// Those of a right lung that only collapses, which may be more, in one piece of what the collapse
/// takes.
Corners cornersAlone(int piece, const ChestField& field)
{
    const double least = double(piece) / kPieces;
    const double most = double(piece + 1) / kPieces;
    const Interval shrink{kMostCollapseAlone * least, kMostCollapseAlone * most};
    Corners corners;
    for (const double shift : {-kMostShift * (1.0 - least), 0.0, kMostShift})
        corners.u.push_back(termsOf({}, shift, shrink, field));
    corners.v.push_back(termsOf({}, 0.0, shrink, field));
    corners.h = corners.v;
    return corners;
}

Place cross(const Place& a, const Place& b)
{
    return {a.v * b.h - a.h * b.v, a.h * b.u - a.u * b.h, a.u * b.v - a.v * b.u};
}

/// Below the determinant at every place of a cell and in every pose.
double boundOn(const ChestFrame<Interval>& frame, const Corners& corners, const Place& cell)
{
    const auto rowsOf = [&](const std::vector<Terms>& poses, Place ChestValue<Interval>::*row,
                            Interval Place::*diagonal) {
        std::vector<Place> rows;
        for (const Terms& terms : poses) {
            rows.push_back(chestValue<false, Interval>(frame, terms, cell).*row);
            rows.back().*diagonal = rows.back().*diagonal + Interval{1.0};
        }
        return rows;
    };
    const auto rows_u = rowsOf(corners.u, &ChestValue<Interval>::slope_u, &Place::u);
    const auto rows_v = rowsOf(corners.v, &ChestValue<Interval>::slope_v, &Place::v);
    const auto rows_h = rowsOf(corners.h, &ChestValue<Interval>::slope_h, &Place::h);
    double least = 1.0;
    for (const Place& v : rows_v) {
        for (const Place& h : rows_h) {
            const Place across = cross(v, h);
            for (const Place& u : rows_u)
                least = std::min(least, (u.u * across.u + u.v * across.v + u.h * across.h).low);
        }
    }
    return least;
}

double widthOf(const Interval& i) { return i.high - i.low; }

/// The two halves of a cell, cut across its longest side.
std::array<Place, 2> halvesOf(const Place& cell)
{
    Interval Place::*longest = &Place::u;
    for (Interval Place::*side : {&Place::v, &Place::h})
        if (widthOf(cell.*side) > widthOf(cell.*longest))
            longest = side;
    const double middle = 0.5 * ((cell.*longest).low + (cell.*longest).high);
    std::array<Place, 2> halves{cell, cell};
    (halves[0].*longest).high = middle;
    (halves[1].*longest).low = middle;
    return halves;
}

} // namespace

/// Proves that the field keeps its orientation, by intervals: a cell of the chest in which the
/// determinant may be too small is halved until it is not, or until the cell is too small. Each
/// piece of the range is a row of its own; left lungs are mirror images.
class TestNoFold : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void foldsNowhereInAnyPose_data()
    {
        QTest::addColumn<Vec3>("hilum");
        QTest::addColumn<int>("piece");
        QTest::addColumn<bool>("onlyCollapses");
        for (const Vec3& hilum : kHila) {
            QTest::addRow("hila at %g, %g, %g; below the lungs", hilum.x(), hilum.y(), hilum.z())
                << hilum << kBelow << false;
            for (int piece = 0; piece < kPieces; ++piece) {
                QTest::addRow("hila at %g, %g, %g; collapse and shift take up to %d/%d", hilum.x(),
                              hilum.y(), hilum.z(), piece + 1, kPieces)
                    << hilum << piece << false;
                QTest::addRow("hila at %g, %g, %g; collapse alone, up to %d/%d", hilum.x(),
                              hilum.y(), hilum.z(), piece + 1, kPieces)
                    << hilum << piece << true;
            }
        }
    }
    void foldsNowhereInAnyPose();
    void wouldSeeAFold();
};

void TestNoFold::foldsNowhereInAnyPose()
{
    QFETCH(Vec3, hilum);
    QFETCH(int, piece);
    QFETCH(bool, onlyCollapses);
    Box lungs_A;
    lungs_A.include(Vec3{-0.13, -0.10, -0.15});
    lungs_A.include(Vec3{0.13, 0.09, 0.10});
    const Vec3 left{0.13 * hilum.x(), -0.10 + 0.19 * hilum.y(), 0.10 - 0.25 * hilum.z()};
    const ChestField field{lungs_A, {-left.x(), left.y(), left.z()}, left};
    const ChestFrame<Interval> frame = exactly(field.frame());
    const Corners corners = onlyCollapses ? cornersAlone(piece, field) : cornersOf(piece, field);
    const Interval height = piece == kBelow ? Interval{1.0, 1.5} : Interval{-0.2, 1.0};
    std::vector<Place> cells{{{-1.2, 0.0}, {-0.2, 1.2}, height}};
    while (!cells.empty()) {
        const Place cell = cells.back();
        cells.pop_back();
        if (boundOn(frame, corners, cell) > kLeastDeterminant)
            continue;
        const double widest = std::max({widthOf(cell.u), widthOf(cell.v), widthOf(cell.h)});
        QVERIFY2(
            widest > kSmallest,
            qPrintable(
                QStringLiteral("at %1, %2, %3").arg(cell.u.low).arg(cell.v.low).arg(cell.h.low)));
        for (const Place& half : halvesOf(cell))
            cells.push_back(half);
    }
}

// A lung that loses half of its extent keeps an eighth of its volume, everywhere.
void TestNoFold::wouldSeeAFold()
{
    const ChestField field;
    const ChestTerms<Interval> half{.shrink = 0.5};
    const Corners corners{{{half, half}}, {{half, half}}, {{half, half}}};
    const Place place{Interval{-0.9}, Interval{0.5}, Interval{0.5}};
    QVERIFY(std::abs(boundOn(exactly(field.frame()), corners, place) - 0.125) < 1e-12);
}

CARINA_TEST(TestNoFold)

} // namespace carina::no_fold_test

#include "tst_no_fold.moc"
