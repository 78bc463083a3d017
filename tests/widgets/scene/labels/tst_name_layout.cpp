#include "tests/support/test_class.h"
#include "widgets/scene/labels/name_layout.h"

#include <QLineF>

#include <algorithm>
#include <random>

namespace carina::name_layout_test
{
namespace
{

constexpr QSize kPicture{800, 600};
constexpr QSize kName{90, 20};

std::vector<NameWish> scattered(std::size_t count, std::uint32_t seed, const QRectF& area)
{
    std::mt19937 random{seed};
    std::uniform_real_distribution<double> share{0.0, 1.0};
    std::vector<NameWish> wishes;
    for (std::size_t i = 0; i < count; ++i) {
        const QPointF anchor{area.left() + share(random) * area.width(),
                             area.top() + share(random) * area.height()};
        const QSize size{40 + static_cast<int>(120.0 * share(random)), 20};
        wishes.push_back({anchor, 1.0 + share(random), size});
    }
    return wishes;
}

/// Two rectangles share a pixel; written out, not by QRect.
bool overlap(const QRect& a, const QRect& b)
{
    return a.x() < b.x() + b.width() && b.x() < a.x() + a.width() && a.y() < b.y() + b.height()
           && b.y() < a.y() + a.height();
}

} // namespace

class TestNameLayout : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void coversNoNameByAnother_data()
    {
        QTest::addColumn<int>("count");
        QTest::addColumn<QRectF>("area");
        const QRectF whole{0.0, 0.0, 800.0, 600.0};
        QTest::newRow("a few") << 5 << whole;
        QTest::newRow("as many as a patient has parts") << 139 << whole;
        QTest::newRow("more than fit") << 283 << QRectF{300.0, 200.0, 200.0, 200.0};
        QTest::newRow("all at one point") << 40 << QRectF{400.0, 300.0, 0.0, 0.0};
        QTest::newRow("in a corner") << 20 << QRectF{0.0, 0.0, 30.0, 30.0};
    }

    void coversNoNameByAnother()
    {
        QFETCH(int, count);
        QFETCH(QRectF, area);
        const auto wishes = scattered(static_cast<std::size_t>(count), 7, area);
        const std::vector<PlacedName> placed = layOutNames(wishes, kPicture);
        QVERIFY(!placed.empty());
        for (std::size_t i = 0; i < placed.size(); ++i) {
            const PlacedName& name = placed[i];
            QCOMPARE(name.box.size(), wishes[name.wish].size);
            QCOMPARE(name.anchor, wishes[name.wish].anchor);
            QVERIFY(QRect({0, 0}, kPicture).contains(name.box));
            QVERIFY(name.box.adjusted(-1, -1, 1, 1).contains(name.leaderEnd.toPoint()));
            for (std::size_t j = 0; j < placed.size(); ++j) {
                if (i == j)
                    continue;
                QVERIFY(!overlap(name.box, placed[j].box));
                QVERIFY(!QRectF{name.box}.contains(placed[j].anchor)
                        || name.anchor == placed[j].anchor);
                if (name.anchor != placed[j].anchor)
                    QVERIFY((QLineF{name.anchor, name.leaderEnd}.intersects(
                                QLineF{placed[j].anchor, placed[j].leaderEnd}, nullptr))
                            != QLineF::BoundedIntersection);
            }
        }
    }

    void givesThePlaceToTheNearest()
    {
        std::vector<NameWish> wishes = scattered(200, 11, {390.0, 290.0, 20.0, 20.0});
        const std::vector<PlacedName> placed = layOutNames(wishes, kPicture);
        QVERIFY(placed.size() < wishes.size());
        const auto depth = [&](const PlacedName& name) { return wishes[name.wish].depth; };
        QVERIFY(std::ranges::is_sorted(placed, {}, depth));
        const auto nearest = std::ranges::min_element(wishes, {}, &NameWish::depth);
        QCOMPARE(placed.front().wish, static_cast<std::size_t>(nearest - wishes.begin()));
    }

    void writesOneNameBesideItsPoint()
    {
        const std::vector<NameWish> wishes{{{400.0, 300.0}, 1.0, kName}};
        const std::vector<PlacedName> placed = layOutNames(wishes, kPicture);
        QCOMPARE(placed.size(), std::size_t{1});
        QVERIFY(placed[0].box.left() > 400 && placed[0].box.left() < 430);
        QVERIFY(std::abs(placed[0].box.center().y() - 300) <= 1);
    }

    void staysInsideThePictureAtItsEdges()
    {
        for (const QPointF& corner :
             {QPointF{0, 0}, QPointF{799, 0}, QPointF{0, 599}, QPointF{799, 599}}) {
            const std::vector<NameWish> wishes{{corner, 1.0, kName}};
            const std::vector<PlacedName> placed = layOutNames(wishes, kPicture);
            QCOMPARE(placed.size(), std::size_t{1});
            QVERIFY(QRect({0, 0}, kPicture).contains(placed[0].box));
        }
        const std::vector<NameWish> tooLong{{{400.0, 300.0}, 1.0, {900, 20}}};
        QVERIFY(layOutNames(tooLong, kPicture).empty());
    }

    /// A name that moves with each frame cannot be read, and is seen twice where frames are slow:
    /// where it was until the next one is drawn, and where it is.
    void restsWhileWhatItNamesMovesALittle()
    {
        NameWish wish{{400.0, 300.0}, 1.0, kName};
        const QRect first = layOutNames({&wish, 1}, kPicture).at(0).box;
        wish.before = first;
        for (const QPointF& by : {QPointF{6, 0}, QPointF{-30, 20}, QPointF{-10, -40}}) {
            wish.anchor = QPointF{400.0, 300.0} + by;
            const auto placed = layOutNames({&wish, 1}, kPicture);
            QCOMPARE(placed.at(0).box, first);
            QCOMPARE(placed.at(0).anchor, wish.anchor); // the leader line goes with it
        }
        const auto goesElsewhere = [&](const NameWish& moved, std::span<const QRect> taken) {
            const auto placed = layOutNames({&moved, 1}, kPicture, taken);
            return placed.size() == 1 && placed[0].box != first;
        };
        wish.anchor = QPointF{first.center()}; // covered
        QVERIFY(goesElsewhere(wish, {}));
        wish.anchor = {200.0, 300.0}; // far away
        QVERIFY(goesElsewhere(wish, {}));
        wish.anchor = {400.0, 300.0};
        QVERIFY(goesElsewhere(wish, {&first, 1}));
    }

    void leavesWhatIsTakenFree()
    {
        const std::vector<NameWish> wishes{{{400.0, 300.0}, 1.0, kName}};
        const std::vector<QRect> taken{{405, 100, 395, 400}}; // all to the right
        const std::vector<PlacedName> placed = layOutNames(wishes, kPicture, taken);
        QCOMPARE(placed.size(), std::size_t{1});
        QVERIFY(!overlap(placed[0].box, taken[0]));
    }
};

CARINA_TEST(TestNameLayout)

} // namespace carina::name_layout_test

#include "tst_name_layout.moc"
