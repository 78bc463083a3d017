#include "engine/airway/tube/tube_size.h"
#include "engine/anatomy/shapes/tube.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::tube_size_test
{

class TestTubeSize : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hasFourteenSizes();
    void isStiffAsAnEmptyCylinder();
    void refusesOtherSizes();
};

void TestTubeSize::hasFourteenSizes()
{
    QCOMPARE(tubeSizes().size(), std::size_t{14});
    for (const Length inner : tubeSizes()) {
        const Result<TubeSize> size = tubeOfSize(inner);
        QVERIFY(size.has_value());
        QCOMPARE(size->outer.si, outerDiameterOf(inner).si);
        QVERIFY(size->outer > size->inner);
    }
}

void TestTubeSize::isStiffAsAnEmptyCylinder()
{
    // 1 MPa, 5 mm outside and 4 mm inside: pi / 4 (625 - 256) mm^4 = 289.81 mm^4.
    const double found = bendingStiffness(1e6, millimetres(5.0), millimetres(4.0));
    QVERIFY(std::abs(found - 2.8981e-4) < 1e-8);
}

void TestTubeSize::refusesOtherSizes()
{
    QVERIFY(!tubeOfSize(millimetres(2.0)));
    QVERIFY(!tubeOfSize(millimetres(9.5)));
    QVERIFY(!tubeOfSize(millimetres(std::nan(""))));
}

CARINA_TEST(TestTubeSize)

} // namespace carina::tube_size_test

#include "tst_tube_size.moc"
