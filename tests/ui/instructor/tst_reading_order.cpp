#include "tests/support/test_class.h"
#include "ui/instructor/reading_order.h"

#include <QDockWidget>
#include <QLineEdit>
#include <QMainWindow>
#include <QPushButton>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>

namespace carina::reading_order_test
{
namespace
{

/// A window whose parts were made in another order than they are read in.
struct Shown {
    QMainWindow window;
    QStringList wanted{QStringLiteral("tool"),       QStringLiteral("high left"),
                       QStringLiteral("high right"), QStringLiteral("high below"),
                       QStringLiteral("low"),        QStringLiteral("middle"),
                       QStringLiteral("status")};

    Shown()
    {
        addStatus();
        addDock(QStringLiteral("low"));
        addMiddle();
        addHighDock();
        auto* bar = window.addToolBar(QStringLiteral("bar"));
        bar->addWidget(button(QStringLiteral("tool")));
        window.splitDockWidget(window.findChild<QDockWidget*>(QStringLiteral("high")),
                               window.findChild<QDockWidget*>(QStringLiteral("low")), Qt::Vertical);
        window.resize(900, 700);
        window.show();
    }
    [[nodiscard]] static QPushButton* button(const QString& name)
    {
        auto* made = new QPushButton{name};
        made->setObjectName(name);
        made->setFocusPolicy(Qt::StrongFocus);
        return made;
    }
    void addStatus() { window.statusBar()->addWidget(button(QStringLiteral("status"))); }
    void addMiddle() { window.setCentralWidget(button(QStringLiteral("middle"))); }
    void addDock(const QString& name)
    {
        auto* dock = new QDockWidget;
        dock->setObjectName(name);
        dock->setWidget(button(name));
        window.addDockWidget(Qt::LeftDockWidgetArea, dock);
    }
    void addHighDock()
    {
        auto* page = new QWidget;
        auto* right = button(QStringLiteral("high right"));
        auto* column = new QVBoxLayout{page};
        auto* row = new QHBoxLayout;
        row->addWidget(button(QStringLiteral("high left")));
        row->addWidget(right);
        right->setFixedHeight(60); // higher than what stands beside it
        column->addLayout(row);
        column->addWidget(button(QStringLiteral("high below")));
        auto* dock = new QDockWidget;
        dock->setObjectName(QStringLiteral("high"));
        dock->setWidget(page);
        window.addDockWidget(Qt::LeftDockWidgetArea, dock);
    }
    /// The names on the way from the first control, once around.
    [[nodiscard]] QStringList walk(bool forward)
    {
        QStringList names;
        window.findChild<QWidget*>(QStringLiteral("tool"))->setFocus();
        for (int step = 0; step < wanted.size(); ++step) {
            names += window.focusWidget()->objectName();
            focusNextAsRead(window, forward);
        }
        return names;
    }
};

} // namespace

class TestReadingOrder : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void goesThroughTheWindowAsItIsRead()
    {
        Shown shown;
        QCOMPARE(shown.walk(true), shown.wanted);
    }

    void goesBackTheSameWay()
    {
        Shown shown;
        QStringList back{shown.wanted.first()};
        for (qsizetype place = shown.wanted.size() - 1; place > 0; --place)
            back += shown.wanted[place];
        QCOMPARE(shown.walk(false), back);
    }

    void leavesOutWhatCannotBeUsed()
    {
        Shown shown;
        shown.window.findChild<QWidget*>(QStringLiteral("high left"))->setEnabled(false);
        shown.window.findChild<QWidget*>(QStringLiteral("high below"))->hide();
        shown.window.findChild<QWidget*>(QStringLiteral("tool"))->setFocus();
        QVERIFY(focusNextAsRead(shown.window, true));
        QCOMPARE(shown.window.focusWidget()->objectName(), QStringLiteral("high right"));
        QVERIFY(focusNextAsRead(shown.window, true));
        QCOMPARE(shown.window.focusWidget()->objectName(), QStringLiteral("low"));
    }
};

CARINA_SCREEN_TEST(TestReadingOrder)

} // namespace carina::reading_order_test

#include "tst_reading_order.moc"
