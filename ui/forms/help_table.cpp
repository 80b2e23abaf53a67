#include "ui/forms/help_table.h"

#include <QStringList>

#include "ui/forms/field_text.h"

namespace rotorbench {

using schema::Kind;

namespace {

QString escaped(const std::string& text) {
  return toQString(text).toHtmlEscaped();
}

QString optionsHtml(const schema::Field& field) {
  QStringList lines;
  for (const auto& option : field.options) {
    QString line = escaped(option.label);
    if (!option.help.empty()) line += QStringLiteral(": ") + escaped(option.help);
    lines += line;
  }
  return lines.join(QStringLiteral("<br>"));
}

QString allowedHtml(const schema::Field& field, const QString& unit, const QLocale& locale) {
  switch (field.kind) {
    case Kind::Choice:
    case Kind::Variant:
      return optionsHtml(field);
    case Kind::Boolean:
      return QStringLiteral("on or off");
    default:
      return rangeText(field, unit, locale).toHtmlEscaped();
  }
}

QString defaultHtml(const schema::Field& field, const void* owner, const QString& unit,
                    const QLocale& locale) {
  if (field.isLeaf()) {
    return valueText(field, field.read(owner), unit, locale).toHtmlEscaped();
  }
  if (field.kind == Kind::Variant) return escaped(field.options[field.chosen(owner)].label);
  if (field.kind == Kind::List) return QString::number(field.count(owner));
  return {};
}

void addRows(schema::ConstRef object, const QString& prefix, const QLocale& locale, QString& html) {
  for (const auto& field : object.type->fields) {
    const QString key = prefix + toQString(field.key);
    if (field.kind == Kind::Group) {
      html += QStringLiteral("<tr><th colspan=\"7\" align=\"left\">%1</th></tr>\n")
                  .arg(escaped(field.label));
      addRows({&field.childType(object.object, 0), field.constChild(object.object, 0)},
              key + QLatin1Char('.'), locale, html);
      continue;
    }
    const QString unit = toQString(field.displayUnit);
    const QStringList cells{
        field.symbol.empty() ? QString() : symbolHtml(toQString(field.symbol)),
        QStringLiteral("%1<br><code>%2</code>").arg(escaped(field.label), key.toHtmlEscaped()),
        prettyUnit(unit).toHtmlEscaped(),
        allowedHtml(field, unit, locale),
        defaultHtml(field, object.object, unit, locale),
        escaped(field.help),
        escaped(field.source)};
    html += QStringLiteral("<tr><td>%1</td></tr>\n").arg(cells.join(QStringLiteral("</td><td>")));
  }
}

}  // namespace

QString parameterTableHtml(const schema::Type& type, const QLocale& locale) {
  QString html = QStringLiteral(
      "<table border=\"1\" cellspacing=\"0\" cellpadding=\"4\">\n"
      "<tr><th>Symbol</th><th>Parameter</th><th>Unit</th><th>Allowed</th><th>Default</th>"
      "<th>Meaning</th><th>Source</th></tr>\n");
  const auto defaults = type.make();
  addRows({&type, defaults.get()}, {}, locale, html);
  return html + QStringLiteral("</table>\n");
}

}  // namespace rotorbench
