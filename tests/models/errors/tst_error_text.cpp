#include "models/errors/error_text.h"
#include "tests/support/test_class.h"

#include <QSet>

namespace carina::error_text_test
{

class TestErrorText : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hasASentenceOfItsOwnForEveryCode();
    void weavesTheParticularsIn();
    void leavesNoTraceOfParticularsThatAreNotThere();
    void takesParticularsAsTheyAre();
};

void TestErrorText::hasASentenceOfItsOwnForEveryCode()
{
    QSet<QString> sentences;
    // A number that is no code has no sentence; the codes are numbered from 0 without gaps.
    int codes = 0;
    while (!errorText({Errc(codes), {}}).isEmpty())
        sentences.insert(errorText({Errc(codes++), {}}));
    QVERIFY(codes > int(Errc::NoGraphics));
    QCOMPARE(sentences.size(), codes);
    for (const QString& sentence : std::as_const(sentences)) {
        QVERIFY2(sentence.endsWith(QLatin1Char('.')), qPrintable(sentence));
        QVERIFY2(sentence.contains(QLatin1String(": ")), qPrintable(sentence)); // what to do next
    }
}

void TestErrorText::weavesTheParticularsIn()
{
    QCOMPARE(errorText({Errc::FileEmpty, "lung.obj"}),
             QStringLiteral("A file is empty (lung.obj): copy or export it again."));
    for (int code = 0; code <= int(Errc::NoGraphics); ++code)
        QVERIFY(errorText({Errc(code), "lung.obj"}).contains(QLatin1String(" (lung.obj)")));
}

void TestErrorText::leavesNoTraceOfParticularsThatAreNotThere()
{
    QCOMPARE(errorText({Errc::FileEmpty, {}}),
             QStringLiteral("A file is empty: copy or export it again."));
}

void TestErrorText::takesParticularsAsTheyAre()
{
    QCOMPARE(errorText({Errc::FileEmpty, "%1 100%2 \xc3\xa9"}),
             QStringLiteral("A file is empty (%1 100%2 é): copy or export it again."));
}

CARINA_TEST(TestErrorText)

} // namespace carina::error_text_test

#include "tst_error_text.moc"
