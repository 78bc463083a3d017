#include "engine/core/result.h"
#include "tests/support/test_class.h"

namespace carina::result_test
{
namespace
{

Result<int> half(int number)
{
    if (number % 2 != 0)
        return fail(Errc::OutOfRange, std::to_string(number) + " is odd");
    return number / 2;
}

} // namespace

class ResultTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void holdsTheValue()
    {
        QVERIFY(half(8));
        QCOMPARE(*half(8), 4);
    }

    void holdsTheReasonWhyThereIsNone()
    {
        const Result<int> result = half(7);
        QVERIFY(!result);
        QCOMPARE(result.error().code, Errc::OutOfRange);
        QCOMPARE(result.error().detail, std::string{"7 is odd"});
    }

    void comparesErrorsByCodeAndDetail()
    {
        const Error error{Errc::FileEmpty, "a.obj"};
        QVERIFY((error == Error{Errc::FileEmpty, "a.obj"}));
        QVERIFY((error != Error{Errc::FileEmpty, "b.obj"}));
        QVERIFY((error != Error{Errc::FileMalformed, "a.obj"}));
    }

    void failsWithoutDetail()
    {
        const Result<void> result = fail(Errc::NotFinite);
        QCOMPARE(result.error().code, Errc::NotFinite);
        QVERIFY(result.error().detail.empty());
    }

    void passesAFailureThroughAChain()
    {
        QCOMPARE(half(12).and_then(half).value(), 3);
        QCOMPARE(half(6).and_then(half).error().detail, std::string{"3 is odd"});
    }
};

CARINA_TEST(ResultTest)

} // namespace carina::result_test

#include "tst_result.moc"
