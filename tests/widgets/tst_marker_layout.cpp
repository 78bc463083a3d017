#include "widgets/marker_layout.h"

#include "tests/support/test_class.h"

#include <QSignalSpy>

namespace carina::marker_layout_test
{
namespace
{

/// As of the pointer 8700340 of NDI.
const std::vector<MarkerLayout::Point> kPointer{
    {0.0, 0.0, 0.0}, {0.0, 0.0, 50.0}, {0.0, 25.0, 100.0}, {0.0, -25.0, 135.0}};

class Shown : public MarkerLayout
{
public:
    Shown()
    {
        resize(600, 300);
        setPoints(kPointer);
    }
};

} // namespace

class MarkerLayoutTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// One scale for both pictures, and in each for both directions; y is up.
    void drawsAtOneScale()
    {
        const Shown view;
        const QPointF front = view.placeFromFront({});
        const QPointF side = view.placeFromSide({});
        const double unit = view.unit();
        QVERIFY(unit > 0.5);
        const MarkerLayout::Point p{7.0, 11.0, 13.0};
        constexpr double kPixels = 1e-9;
        QVERIFY(std::abs(view.placeFromFront(p).x() - front.x() - 7.0 * unit) < kPixels);
        QVERIFY(std::abs(front.y() - view.placeFromFront(p).y() - 11.0 * unit) < kPixels);
        QVERIFY(std::abs(view.placeFromSide(p).x() - side.x() - 13.0 * unit) < kPixels);
        QVERIFY(std::abs(side.y() - view.placeFromSide(p).y() - 11.0 * unit) < kPixels);
    }

    void showsAllMarkersInTheirHalves()
    {
        const Shown view;
        for (const MarkerLayout::Point& point : kPointer) {
            QVERIFY(QRectF(0, 0, 300, 300).contains(view.placeFromFront(point)));
            QVERIFY(QRectF(300, 0, 300, 300).contains(view.placeFromSide(point)));
        }
    }

    void tellsItsScaleInARoundNumber_data()
    {
        QTest::addColumn<double>("size_mm");
        for (const double size : {12.0, 90.0, 135.0, 700.0})
            QTest::addRow("%g mm", size) << size;
    }

    void tellsItsScaleInARoundNumber()
    {
        QFETCH(double, size_mm);
        Shown view;
        view.setPoints({{}, {0.0, 0.0, size_mm}});
        const double bar = view.barLength_mm();
        const double digit = bar / std::pow(10.0, std::floor(std::log10(bar) + 1e-9));
        QVERIFY(std::abs(digit - 1.0) < 1e-9 || std::abs(digit - 2.0) < 1e-9
                || std::abs(digit - 5.0) < 1e-9);
        QVERIFY(bar * view.unit() > 0.1 * 300 && bar * view.unit() < 150.0);
    }

    void selectsByKeyAndByClick()
    {
        Shown view;
        const QSignalSpy chosen{&view, &MarkerLayout::chosen};
        QTest::keyClick(&view, Qt::Key_Right);
        QCOMPARE(view.selected(), 0);
        QTest::keyClick(&view, Qt::Key_Right);
        QCOMPARE(view.selected(), 1);
        QTest::mouseClick(&view, Qt::LeftButton, {}, view.placeFromSide(kPointer[3]).toPoint());
        QCOMPARE(view.selected(), 3);
        QTest::keyClick(&view, Qt::Key_Right); // the last one
        QCOMPARE(view.selected(), 3);
        QCOMPARE(chosen.count(), 3);
        QVERIFY(view.accessibleDescription().contains(QStringLiteral("z 135.00 mm")));
    }

    void drawsSomethingOnlyWhereThereAreMarkers()
    {
        Shown view;
        const QImage drawn = view.grab().toImage();
        view.setPoints({});
        QVERIFY(drawn != view.grab().toImage());
        QCOMPARE(view.selected(), -1);
    }
};

CARINA_SCREEN_TEST(MarkerLayoutTest)

} // namespace carina::marker_layout_test

#include "tst_marker_layout.moc"
