#include "widgets/volume_view.h"

#include "tests/support/test_class.h"

namespace carina::volume_view_test
{

class VolumeViewTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// One scale for both pictures, and in each for both directions.
    void drawsAtOneScale()
    {
        const Pyramid view;
        const auto at = [](double depth, double up, double aside) {
            return VolumeView::Thing{{}, depth, up, aside};
        };
        const QPointF origin = view.placeFromSide(at(1.0, 0.0, 0.0));
        const double unit = view.placeFromSide(at(2.0, 0.0, 0.0)).x() - origin.x();
        QVERIFY(unit > 10.0);
        QVERIFY(std::abs(origin.y() - view.placeFromSide(at(1.0, 0.5, 0.0)).y() - 0.5 * unit)
                < 1e-9);
        const QPointF above = view.placeFromAbove(at(1.0, 0.0, 0.0));
        QVERIFY(std::abs(above.y() - view.placeFromAbove(at(1.0, 0.0, 0.5)).y() - 0.5 * unit)
                < 1e-9);
        QVERIFY(std::abs(view.placeFromAbove(at(2.0, 0.0, 0.0)).x() - above.x() - unit) < 1e-9);
    }

    void keepsInThePictureWhatIsFarOutside()
    {
        const Pyramid view;
        const QPointF place = view.placeFromSide({{}, 50.0, -50.0, 0.0, false});
        QVERIFY(QRectF(0, 0, 200, 150).contains(place));
    }

    void drawsEveryTool()
    {
        Pyramid view;
        const QImage empty = view.grab().toImage();
        view.setThings({{QStringLiteral("Tube"), 1.5, 0.0, 0.0, true}});
        const QImage inside = view.grab().toImage();
        view.setThings({{QStringLiteral("Tube"), 1.5, 0.0, 0.0, false}});
        QVERIFY(inside != empty && view.grab().toImage() != inside);
    }

    void drawsNoNameUponAnother()
    {
        Pyramid view;
        const std::vector<VolumeView::Thing> things{{QStringLiteral("Stylus"), 1.5, 0.0, 0.0},
                                                    {QStringLiteral("Chin probe"), 1.5, 0.0, 0.01},
                                                    {QStringLiteral("Tube"), 1.52, 0.01, 0.0},
                                                    {QStringLiteral("Headset"), 9.0, 0.0, 9.0}};
        view.setThings(things);
        const std::vector<QRectF> pictures{{0, 0, 200, 150}, {200, 0, 200, 150}};
        int which = 0;
        for (const auto& names : {view.namesFromSide(), view.namesFromAbove()}) {
            QCOMPARE(names.size(), things.size());
            for (std::size_t i = 0; i < names.size(); ++i) {
                QVERIFY(pictures[std::size_t(which)].contains(names[i]));
                for (std::size_t j = 0; j < i; ++j)
                    QVERIFY(!names[i].intersects(names[j]));
            }
            ++which;
        }
    }

private:
    struct Pyramid : VolumeView {
        Pyramid()
        {
            resize(400, 150);
            setVolume({{1.0, 0.2, 0.2}, {2.0, 0.6, 0.7}});
        }
    };
};

CARINA_SCREEN_TEST(VolumeViewTest)

} // namespace carina::volume_view_test

#include "tst_volume_view.moc"
