#include "evaluation/intubation/motion_parameters.h"

#include "evaluation/intubation/motion_script.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <set>

namespace carina::motion_parameters_test
{

class TestMotionParameters : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void drawsOneParameterFromOutsideInAThirdOfTheRuns()
    {
        constexpr int kRuns = 3000;
        int outside = 0;
        for (int seed = 0; seed < kRuns; ++seed) {
            const MotionKind kind = kNamedMotions[std::size_t(seed) % kNamedMotions.size()].kind;
            std::mt19937 random = generatorOf(kind, std::uint32_t(seed));
            const MotionParameters drawn = drawnParameters(kind, random);
            outside += drawn.outside ? 1 : 0;
            if (drawn.outside)
                QVERIFY(uses(kind, *drawn.outside));
            for (std::size_t i = 0; i < kMotionParameters; ++i) {
                const auto parameter = static_cast<MotionParameter>(i);
                const MotionRange& range = rangeOf(parameter);
                const double value = drawn[parameter];
                const bool isUsual = value >= range.least && value <= range.most;
                QVERIFY2(isUsual == (drawn.outside != parameter), range.name.data());
                QVERIFY(value >= std::min(range.least, range.beyond)
                        && value <= std::max(range.most, range.beyond));
            }
        }
        // Four standard deviations of a binomial count.
        QVERIFY(std::abs(outside - kRuns / 3.0) < 4.0 * std::sqrt(kRuns * 2.0 / 9.0));
    }

    void drawsEachParameterFromOutsideNowAndThen()
    {
        std::set<std::string_view> seen;
        for (const NamedMotion& motion : kNamedMotions)
            for (std::uint32_t seed = 1; seed <= 400; ++seed) {
                std::mt19937 random = generatorOf(motion.kind, seed);
                if (const auto drawn = drawnParameters(motion.kind, random); drawn.outside)
                    seen.insert(rangeOf(*drawn.outside).name);
            }
        QCOMPARE(seen.size(), kMotionParameters);
    }

    void drawsTheSameAgain()
    {
        for (const NamedMotion& motion : kNamedMotions) {
            std::mt19937 once = generatorOf(motion.kind, 7);
            std::mt19937 again = generatorOf(motion.kind, 7);
            std::mt19937 other = generatorOf(motion.kind, 8);
            const MotionParameters drawn = drawnParameters(motion.kind, once);
            QCOMPARE(drawnParameters(motion.kind, again).values, drawn.values);
            QVERIFY(drawnParameters(motion.kind, other).values != drawn.values);
        }
    }
};

CARINA_TEST(TestMotionParameters)

} // namespace carina::motion_parameters_test

#include "tst_motion_parameters.moc"
