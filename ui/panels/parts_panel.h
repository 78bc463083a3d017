#pragma once

#include "widgets/scene/look/part_look.h"

#include <QWidget>

#include <functional>
#include <vector>

class QLineEdit;
class QPushButton;
class QTreeWidget;

namespace carina
{

class SceneView;

/// Which parts of the patient a view shows, and how: solid, ghost, hidden, highlighted, labelled,
/// in a plain colour. The buttons apply to the parts selected in the list, by mouse or keyboard;
/// the text field above filters the list.
class PartsPanel : public QWidget
{
    Q_OBJECT

public:
    explicit PartsPanel(QWidget* parent = nullptr);

    /// Lists the parts that the view has now. @pre the view outlives the panel.
    void setScene(SceneView& scene);

private:
    void layOut();
    [[nodiscard]] QPushButton* styleButton(const QString& text, const QString& toolTip,
                                           PartStyle style);
    /// A button and the member of PartLook that it toggles.
    struct Switch {
        QPushButton* button;
        bool PartLook::*which;
    };
    [[nodiscard]] Switch switchFor(const QString& text, const QString& toolTip,
                                   bool PartLook::*which);
    [[nodiscard]] static QString wordsFor(const PartLook& look);
    [[nodiscard]] std::vector<std::uint16_t> chosen() const;
    void changeChosen(const std::function<void(PartLook&)>& change);
    void showAll();
    void filter(const QString& words);
    void refresh();

    SceneView* m_scene = nullptr;
    QLineEdit* m_words;
    QTreeWidget* m_parts;
    std::vector<QPushButton*> m_styles;
    Switch m_highlight;
    Switch m_label;
    Switch m_plain; ///< shown only if a part has vertex colours
    QPushButton* m_showAll;
};

} // namespace carina
