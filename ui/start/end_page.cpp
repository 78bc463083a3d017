#include "ui/start/end_page.h"

#include "widgets/plain_label.h"

#include <QFormLayout>
#include <QPushButton>
#include <QVBoxLayout>

namespace carina
{
namespace
{

constexpr int kEndPageWidth = 720;
constexpr double kHeadingSize = 1.6; ///< as a multiple of the words' size

} // namespace

EndPage::EndPage(const std::vector<SummaryLine>& told)
{
    setWindowTitle(tr("Carina instructor"));
    auto* heading = new PlainLabel{tr("The session has ended")};
    QFont font = heading->font();
    font.setPointSizeF(kHeadingSize * font.pointSizeF());
    heading->setFont(font);
    auto* lines = new QFormLayout;
    for (const SummaryLine& line : told) {
        auto* value = new PlainLabel{line.value};
        value->setWordWrap(true);
        value->setAccessibleName(line.name);
        value->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
        lines->addRow(line.name, value);
    }
    auto* another = new QPushButton{tr("&New session")};
    another->setObjectName(QStringLiteral("another"));
    another->setDefault(true);
    connect(another, &QPushButton::clicked, this, &EndPage::anotherWanted);
    auto* close = new QPushButton{tr("&Close")};
    close->setObjectName(QStringLiteral("close"));
    connect(close, &QPushButton::clicked, this, &QWidget::close);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch();
    buttons->addWidget(another);
    buttons->addWidget(close);
    auto* page = new QWidget;
    page->setMaximumWidth(kEndPageWidth);
    auto* column = new QVBoxLayout{page};
    column->addWidget(heading);
    column->addLayout(lines);
    column->addLayout(buttons);
    auto* middle = new QHBoxLayout;
    middle->addWidget(page);
    auto* around = new QVBoxLayout{this};
    around->addStretch();
    around->addLayout(middle);
    around->addStretch();
    another->setFocus();
}

} // namespace carina
