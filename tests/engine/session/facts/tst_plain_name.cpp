#include "engine/session/facts/plain_name.h"
#include "tests/support/test_class.h"

namespace carina::plain_name_test
{

/// Names by which people can be told apart.
class TestPlainName : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void takesNamesOfManyScripts()
    {
        for (const char* name :
             {"Anna", "Dr. Hall", "José María", "Мария", "李 小龍", "O'Brien-Smith", "أحمد",
              "Anna 2", "Nguye\u0302\u0303n", "ชื่น", "ஸ்ரீ", "क्षितिज"})
            QVERIFY2(checkName(name).has_value(), name);
        QVERIFY(checkName(std::string(kLongestName, 'a')).has_value());
    }

    void refusesWhatCannotBeSeen_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::newRow("nothing") << QByteArray{""};
        QTest::newRow("blanks") << QByteArray{"   "};
        QTest::newRow("blank at the end") << QByteArray{"Anna "};
        QTest::newRow("no-break space in front") << QByteArray{"\u00a0Anna"};
        QTest::newRow("new line") << QByteArray{"Anna\nDr. Hall"};
        QTest::newRow("escape") << QByteArray{"Anna\x1b[31m"};
        QTest::newRow("zero-width space") << QByteArray{"An\u200bna"};
        QTest::newRow("zero-width joiner") << QByteArray{"An\u200dna"};
        QTest::newRow("right-to-left override") << QByteArray{"Anna\u202e"};
        QTest::newRow("isolate") << QByteArray{"\u2066Anna\u2069"};
        QTest::newRow("soft hyphen") << QByteArray{"An\u00adna"};
        QTest::newRow("byte order mark") << QByteArray{"\ufeffAnna"};
        QTest::newRow("line separator") << QByteArray{"Anna\u2028"};
        QTest::newRow("variation selector") << QByteArray{"Anna\ufe0f"};
        QTest::newRow("Hangul filler") << QByteArray{"\u3164"};
        QTest::newRow("private use") << QByteArray{"\ue000"};
        QTest::newRow("Braille pattern without dots") << QByteArray{"Anna\u2800"};
        QTest::newRow("note head that is not drawn") << QByteArray{"\U0001d159"};
        QTest::newRow("filler of Khitan") << QByteArray{"An\U00016fe4na"};
        QTest::newRow("object replacement") << QByteArray{"\ufffc"};
        QTest::newRow("character replacement") << QByteArray{"Anna\ufffd"};
        QTest::newRow("a mark alone") << QByteArray{"\u0301"};
        QTest::newRow("a mark in front") << QByteArray{"\u0301Anna"};
        QTest::newRow("a mark behind a blank") << QByteArray{"Anna \u0301b"};
        QTest::newRow("four marks") << QByteArray{"Ann\u0301\u0302\u0303\u0304a"};
        QTest::newRow("63 marks") << QByteArray{"a"}.append(QByteArray{"\u0301"}.repeated(63));
        QTest::newRow("too long") << QByteArray(kLongestName + 1, 'a');
    }

    void refusesWhatCannotBeSeen()
    {
        QFETCH(QByteArray, name);
        const auto checked = checkName(name.toStdString());
        QVERIFY(!checked);
        QCOMPARE(checked.error().code, Errc::NameUnclear);
    }

    /// Pairs of Unicode Technical Standard 39's confusables.
    void seesWhatLooksAlike()
    {
        for (const char* other : {"anna", "ANNA", "\u0410nna", "An na", "Ann\u0430"})
            QVERIFY2(lookAlike("Anna", other), other);
        QVERIFY(lookAlike("paypal", "\u0440\u0430y\u0440\u0430l"));
        for (const char* other : {"lnstructor", "1nstructor", "instructor", "|nstructor"})
            QVERIFY2(lookAlike("Instructor", other), other);
        QVERIFY(lookAlike("Trainee I", "Trainee l"));
        for (const char* blank : {"\u2800", "\U0001d159", "\U00016fe4"})
            QVERIFY(lookAlike("Anna", std::string{"Anna"} + blank));
        for (const char* other : {"Anne", "Hanna", "Anna2"})
            QVERIFY2(!lookAlike("Anna", other), other);
    }
};

CARINA_TEST(TestPlainName)

} // namespace carina::plain_name_test

#include "tst_plain_name.moc"
