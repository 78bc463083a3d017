#include "engine/anatomy/mouth/lip_shape.h"
#include "engine/anatomy/patient/patient_name.h"
#include "engine/geometry/rotation.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>

namespace carina::lip_shape_test
{
namespace
{

BodyPlan planOf(const QString& words, Posture posture)
{
    return bodyPlanOf(dimensionsFor(patientFromWords(words.toStdString()).value()).value(),
                      posture);
}

/// How far the jaw of a laryngoscopy, 20 degrees open and 8 mm forward in an adult, is from where
/// it is held open in the surfaces, by 11.7 degrees, about the line through the condyles.
RigidTransform fartherOpen(const BodyPlan& plan)
{
    const Vec3 hinge = plan.inFace({0.0, 87.0, 45.0});
    const Vec3 forward = -8.0 * plan.face * Vec3::UnitY();
    return RigidTransform::translation(hinge + forward)
           * RigidTransform{rotationFromVector(degrees(20.0 - 11.7).si * Vec3::UnitX()),
                            Vec3::Zero()}
           * RigidTransform::translation(-hinge);
}

} // namespace

class TestLipShape : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void meetAtTheCorners_data() { people(); }
    void meetAtTheCorners();
    void stayTogetherInALaryngoscopy_data() { people(); }
    void stayTogetherInALaryngoscopy();
    void upperOneHasACupidsBow_data() { people(); }
    void upperOneHasACupidsBow();

private:
    static void people()
    {
        QTest::addColumn<QString>("words");
        for (const char* words : {"adult", "child", "1 year, 75 cm, girl", "newborn, 50 cm, girl"})
            QTest::newRow(words) << QString::fromLatin1(words);
    }
};

/// With the mouth closed and held open, on both sides.
void TestLipShape::meetAtTheCorners()
{
    QFETCH(QString, words);
    for (const Posture posture : {Posture::Rest, Posture::Laryngoscopy}) {
        const BodyPlan plan = planOf(words, posture);
        const Lips lips{plan};
        for (const double side : {1.0, -1.0}) {
            const Vec3& corner = lips.p_A_corner();
            const Vec3 p_A{side * corner.x(), corner.y(), corner.z()};
            QVERIFY(lips.upper(p_A) < -1.5 * plan.face);
            QVERIFY(lips.lower(p_A) < -1.5 * plan.face);
        }
        // And are apart in the midline, where one looks in.
        const Vec3 upper = plan.inFace({0.0, -7.0, 0.0});
        QVERIFY(lips.upper(upper) > 0.0 && lips.lower(upper) > 0.0);
    }
}

/// Somewhere both are solid, though the lower one has gone on with the jaw.
void TestLipShape::stayTogetherInALaryngoscopy()
{
    QFETCH(QString, words);
    const BodyPlan plan = planOf(words, Posture::Laryngoscopy);
    const Lips lips{plan};
    const RigidTransform back = fartherOpen(plan).inverse();
    double least = 1.0;
    for (double x = -3.0; x <= 3.0; x += 0.5)
        for (double y = -6.0; y <= 8.0; y += 0.5)
            for (double z = -12.0; z <= 4.0; z += 0.5) {
                const Vec3 p_A = lips.p_A_corner() + plan.face * Vec3{x, y, z};
                least = std::min(least, std::max(lips.upper(p_A), lips.lower(back * p_A)));
            }
    QVERIFY2(least < 0.0, qPrintable(QString::number(least / plan.face)));
}

/// Its upper border is lower in the midline, at the philtrum, than at two peaks beside it.
void TestLipShape::upperOneHasACupidsBow()
{
    QFETCH(QString, words);
    const BodyPlan plan = planOf(words, Posture::Laryngoscopy);
    const Lips lips{plan};
    const auto border = [&](double x) {
        for (double z = 20.0; z > 0.0; z -= 0.05)
            for (double y = -14.0; y < 4.0; y += 0.5)
                if (lips.upper(plan.inFace({x, y, z})) < 0.0)
                    return z;
        return 0.0;
    };
    const double middle = border(0.0);
    QVERIFY2(border(5.5) > middle + 0.8, qPrintable(QString::number(border(5.5) - middle)));
    QVERIFY(border(-5.5) > middle + 0.8);
    QVERIFY(border(14.0) < border(5.5) - 1.0);
}

CARINA_TEST(TestLipShape)

} // namespace carina::lip_shape_test

#include "tst_lip_shape.moc"
