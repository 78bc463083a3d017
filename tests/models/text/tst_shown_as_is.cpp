#include "models/text/shown_as_is.h"
#include "tests/support/test_class.h"

#include <QTextDocument>

namespace carina::shown_as_is_test
{

class TestShownAsIs : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void showsWhatItWasGiven_data()
    {
        QTest::addColumn<QString>("text");
        for (const char* text :
             {"", "Tom", "Tom & Tess", "a < b, c > d", "<b>Tom</b>", "<img src=/dev/zero>",
              "&lt;img src=/dev/zero&gt;", "a\nb <c>\n  d", "<?xml version=\"1.0\"?><p>Tom</p>",
              "<!doctype html>Tom", "5 mm, <img src='/dev/zero'>"})
            QTest::newRow(text) << QString::fromLatin1(text);
    }

    /// As Qt would show it in a tooltip: as rich text where it takes it for that.
    void showsWhatItWasGiven()
    {
        QFETCH(const QString, text);
        const QString given = shownAsIs(text);
        if (!Qt::mightBeRichText(given)) {
            QCOMPARE(given, text);
            return;
        }
        QVERIFY(!given.contains(QStringLiteral("<img")));
        QTextDocument document;
        document.setHtml(given);
        QCOMPARE(document.toPlainText(), text);
    }
};

CARINA_TEST(TestShownAsIs)

} // namespace carina::shown_as_is_test

#include "tst_shown_as_is.moc"
