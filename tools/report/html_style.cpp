#include "sim/core/format.hpp"
#include "tools/report/figure_style.hpp"
#include "tools/report/html_parts.hpp"

namespace specula {
namespace {

std::string variables(std::string_view ColourRole::*shade) {
    std::string text;
    for (const ColourRole& role : colour_roles)
        text += format("{}:{};", role.variable, role.*shade);
    return text;
}

/// One column for reading, about 70 characters wide; figures and tables may use more. The two
/// founts are what the reader's system has.
constexpr std::string_view page_layout = R"(
*{box-sizing:border-box}
html{-webkit-text-size-adjust:100%;text-size-adjust:100%}
body{margin:0;background:var(--paper);color:var(--ink);
 font:1.0625rem/1.55 Charter,"Bitstream Charter","Iowan Old Style","Palatino Linotype",Palatino,"Liberation Serif",Georgia,serif;
 font-kerning:normal;hanging-punctuation:first}
main{max-width:64rem;margin:0 auto;padding:3.5rem 1.5rem 4rem}
h1,h2,p,.note{max-width:42rem}
h1{font-size:1.9rem;line-height:1.2;font-weight:600;letter-spacing:-.01em;margin:0 0 .5rem;text-wrap:balance}
h2{font-size:1.22rem;line-height:1.3;font-weight:600;margin:0 0 .6rem}
p{margin:0 0 .85rem;text-wrap:pretty;hyphens:auto}
section,footer{margin-top:2.6rem;padding-top:1.5rem;border-top:1px solid var(--rule)}
.subtitle{color:var(--soft-ink);font-style:italic;margin-bottom:1.4rem}
.summary{font-size:1.125rem;margin-bottom:0}
.lead{font-weight:600}
.figures{display:grid;grid-template-columns:repeat(2,minmax(0,1fr));gap:2.2rem 2.5rem;margin-top:1.6rem;align-items:start}
figure{margin:0;min-width:0}
.column,.full{grid-column:1/-1}
.drawing{overflow-x:auto}
.plot{display:block;max-width:100%;height:auto;overflow:visible}
.full .plot{width:100%}
.plot text{font-family:"Helvetica Neue",Helvetica,Arial,"Liberation Sans",sans-serif;font-variant-numeric:tabular-nums}
figcaption{margin-top:.7rem;font-size:.9rem;line-height:1.45;color:var(--soft-ink);max-width:42rem}
figcaption b{color:var(--ink);font-weight:600}
a{color:inherit;text-underline-offset:.18em;text-decoration-thickness:1px}
.data{white-space:nowrap}
.table{overflow-x:auto}
figure.numbers{margin-top:1.4rem}
.numbers figcaption{margin:0 0 .6rem;max-width:none}
.table:focus-visible,a:focus-visible{outline:2px solid var(--series-1);outline-offset:3px}
table{border-collapse:collapse;width:100%;font-size:.93rem;line-height:1.35;font-variant-numeric:lining-nums tabular-nums}
thead tr:first-child>*{border-top:1.5px solid var(--ink)}
thead tr:last-child>*,thead [rowspan]{border-bottom:1px solid var(--ink)}
tbody tr:last-child>*{border-bottom:1.5px solid var(--ink)}
th,td{padding:.36rem .65rem;text-align:left;vertical-align:baseline;font-weight:400}
thead th{vertical-align:bottom;font-style:italic}
thead th.group{text-align:center;font-style:normal;padding-bottom:0}
.group span{display:block;padding-bottom:.3rem;border-bottom:1px solid var(--soft-ink)}
thead tr:first-child>:first-child,tbody>tr>:first-child{padding-left:0}
thead tr:first-child>:last-child,tbody>tr>:last-child{padding-right:0}
tbody th{min-width:12rem}
.number{text-align:right}
td.number{white-space:nowrap}
.note{font-size:.87rem;line-height:1.45;color:var(--soft-ink);margin:.6rem 0 0}
dl{display:grid;grid-template-columns:max-content minmax(0,1fr);gap:.3rem 1.4rem;margin:0;font-size:.9rem;line-height:1.45}
dt{color:var(--soft-ink)}
dd{margin:0;overflow-wrap:anywhere;font-variant-numeric:lining-nums tabular-nums}
@media (max-width:46rem){
 body{font-size:1rem}
 main{padding:1.8rem 1.1rem 2.5rem}
 h1{font-size:1.55rem}
 .summary{font-size:1.03rem}
 .figures{grid-template-columns:minmax(0,1fr)}
 .full .plot{max-width:none;width:44rem}
 dl{grid-template-columns:minmax(0,1fr);gap:0}
 dd{margin-bottom:.6rem}
}
@media print{
 @page{margin:18mm 16mm}
 body{font-size:10pt}
 main{max-width:none;padding:0}
 h1{font-size:17pt}
 h2{font-size:12pt;break-after:avoid}
 h1,h2,p,.note,figcaption{max-width:none}
 section,footer{margin-top:1.4rem;padding-top:.9rem}
 figure,table,dl{break-inside:avoid}
 .figures{gap:1.2rem 1.4rem}
 .table,.drawing{overflow:visible}
 .data{display:none}
}
)";

}  // namespace

std::string html_style() {
    const std::string light = "--paper:#ffffff;" + variables(&ColourRole::light) + "--ink:#16181a;";
    const std::string dark = "--paper:#17181a;" + variables(&ColourRole::dark);
    return format(
               ":root{{color-scheme:light dark;{}}}\n"
               "@media screen and (prefers-color-scheme:dark){{:root{{{}}}}}",
               light, dark) +
           std::string(page_layout);
}

}  // namespace specula
