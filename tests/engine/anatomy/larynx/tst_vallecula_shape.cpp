#include "engine/anatomy/larynx/vallecula_shape.h"
#include "engine/anatomy/mouth/tongue_shape.h"
#include "engine/anatomy/patient/patient_name.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <string>

namespace carina::vallecula_shape_test
{
namespace
{

/// What is seen from above between tongue and epiglottis, before it is meshed.
class Hollows
{
public:
    Hollows(const QString& words, Posture posture)
        : m_plan(bodyPlanOf(dimensionsFor(patientFromWords(words.toStdString()).value()).value(),
                            posture)),
          m_larynx(m_plan.dimensions),
          m_epiglottis(m_plan),
          m_tongue(m_plan, m_larynx, m_epiglottis),
          m_fold(m_tongue.medianFold().distance),
          m_floor(vallecula(m_larynx, m_epiglottis).shape.distance)
    {
    }

    /// The height of the first surface on the way down, so far to the left and in front of the
    /// epiglottis' middle; millimetres of LarynxFrame.
    [[nodiscard]] double heightAt(double x, double inFront) const
    {
        double z = 32.0;
        while (z > 5.0 && !isSolid({x, m_epiglottis.middleAt(z) - inFront, z}))
            z -= 0.1;
        return z;
    }

private:
    [[nodiscard]] bool isSolid(const Vec3& p) const
    {
        const Vec3 p_A = m_larynx.inAnatomy(p);
        return m_tongue.distance(p_A) < 0.0 || m_fold(p_A) < 0.0 || m_floor(p_A) < 0.0;
    }

    BodyPlan m_plan;
    LarynxFrame m_larynx;
    Epiglottis m_epiglottis;
    Tongue m_tongue;
    Implicit m_fold;
    Implicit m_floor;
};

} // namespace

class TestValleculaShape : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isTwoHollowsBesideTheMedianFold_data();
    void isTwoHollowsBesideTheMedianFold();
};

void TestValleculaShape::isTwoHollowsBesideTheMedianFold_data()
{
    QTest::addColumn<QString>("words");
    for (const char* words : {"adult", "45 years, 165 cm, woman", "child", "6 years, 116 cm, boy",
                              "1 year, 75 cm, girl", "newborn, 50 cm, girl"})
        QTest::newRow(words) << QString::fromLatin1(words);
}

/// A depression on each side of the median glosso-epiglottic fold, bounded to the sides by the
/// lateral ones (Gray 1918).
void TestValleculaShape::isTwoHollowsBesideTheMedianFold()
{
    QFETCH(QString, words);
    const Hollows hollows{words, Posture::Laryngoscopy};
    constexpr double kBelowMedianFold = 5.0;
    constexpr double kBelowLateralFold = 1.5;
    constexpr double kWithoutHole = 12.0; // the floor's underside is higher
    for (const double side : {1.0, -1.0})
        for (const double inFront : {2.5, 4.2, 5.5}) {
            const double deep = hollows.heightAt(5.5 * side, inFront);
            const std::string where =
                std::to_string(side) + ", " + std::to_string(inFront) + ": " + std::to_string(deep);
            QVERIFY2(deep > kWithoutHole, where.c_str());
            QVERIFY2(hollows.heightAt(0.0, inFront) > deep + kBelowMedianFold, where.c_str());
            QVERIFY2(hollows.heightAt(9.5 * side, inFront) > deep + kBelowLateralFold,
                     where.c_str());
        }
}

CARINA_TEST(TestValleculaShape)

} // namespace carina::vallecula_shape_test

#include "tst_vallecula_shape.moc"
